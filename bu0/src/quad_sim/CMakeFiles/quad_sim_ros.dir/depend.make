# Empty dependencies file for quad_sim_ros.
# This may be replaced when dependencies are built.
