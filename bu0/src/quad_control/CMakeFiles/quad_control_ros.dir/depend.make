# Empty dependencies file for quad_control_ros.
# This may be replaced when dependencies are built.
