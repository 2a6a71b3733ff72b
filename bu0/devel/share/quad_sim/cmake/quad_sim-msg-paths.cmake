# generated from genmsg/cmake/pkg-msg-paths.cmake.develspace.in

set(quad_sim_MSG_INCLUDE_DIRS "")
set(quad_sim_MSG_DEPENDENCIES std_msgs;geometry_msgs;nav_msgs;mav_msgs)
