# Empty custom commands generated dependencies file for quad_control_gencpp.
# This may be replaced when dependencies are built.
