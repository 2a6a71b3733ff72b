# Empty dependencies file for quad_support.
# This may be replaced when dependencies are built.
