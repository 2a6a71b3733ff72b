# Empty dependencies file for quad_control.
# This may be replaced when dependencies are built.
