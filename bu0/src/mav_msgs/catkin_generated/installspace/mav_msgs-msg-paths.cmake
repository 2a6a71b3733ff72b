# generated from genmsg/cmake/pkg-msg-paths.cmake.installspace.in

_prepend_path("${mav_msgs_DIR}/.." "msg" mav_msgs_MSG_INCLUDE_DIRS UNIQUE)
set(mav_msgs_MSG_DEPENDENCIES std_msgs;geometry_msgs)
