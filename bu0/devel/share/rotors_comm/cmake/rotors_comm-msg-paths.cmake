# generated from genmsg/cmake/pkg-msg-paths.cmake.develspace.in

set(rotors_comm_MSG_INCLUDE_DIRS "/work/wt/unity/src/rotors_comm/msg")
set(rotors_comm_MSG_DEPENDENCIES std_msgs;geometry_msgs)
