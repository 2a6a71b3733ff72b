# generated from genmsg/cmake/pkg-msg-paths.cmake.develspace.in

set(gazebo_msgs_MSG_INCLUDE_DIRS "/work/wt/unity/src/gazebo_msgs/msg")
set(gazebo_msgs_MSG_DEPENDENCIES std_msgs;geometry_msgs)
