# generated from genmsg/cmake/pkg-msg-paths.cmake.installspace.in

_prepend_path("${quad_sim_DIR}/.." "" quad_sim_MSG_INCLUDE_DIRS UNIQUE)
set(quad_sim_MSG_DEPENDENCIES std_msgs;geometry_msgs;nav_msgs;mav_msgs)
