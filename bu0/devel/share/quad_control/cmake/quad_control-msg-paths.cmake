# generated from genmsg/cmake/pkg-msg-paths.cmake.develspace.in

set(quad_control_MSG_INCLUDE_DIRS "")
set(quad_control_MSG_DEPENDENCIES nav_msgs;mav_msgs)
