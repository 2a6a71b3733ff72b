# generated from genmsg/cmake/pkg-msg-paths.cmake.develspace.in

set(mav_msgs_MSG_INCLUDE_DIRS "/work/wt/unity/src/mav_msgs/msg")
set(mav_msgs_MSG_DEPENDENCIES std_msgs;geometry_msgs)
