# Empty custom commands generated dependencies file for quad_control_genpy.
# This may be replaced when dependencies are built.
