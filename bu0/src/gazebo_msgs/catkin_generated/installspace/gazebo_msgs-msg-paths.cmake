# generated from genmsg/cmake/pkg-msg-paths.cmake.installspace.in

_prepend_path("${gazebo_msgs_DIR}/.." "msg" gazebo_msgs_MSG_INCLUDE_DIRS UNIQUE)
set(gazebo_msgs_MSG_DEPENDENCIES std_msgs;geometry_msgs)
