# generated from genmsg/cmake/pkg-msg-paths.cmake.installspace.in

_prepend_path("${quad_control_DIR}/.." "" quad_control_MSG_INCLUDE_DIRS UNIQUE)
set(quad_control_MSG_DEPENDENCIES nav_msgs;mav_msgs)
