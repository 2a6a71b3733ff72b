# generated from genmsg/cmake/pkg-msg-paths.cmake.installspace.in

_prepend_path("${rotors_comm_DIR}/.." "msg" rotors_comm_MSG_INCLUDE_DIRS UNIQUE)
set(rotors_comm_MSG_DEPENDENCIES std_msgs;geometry_msgs)
