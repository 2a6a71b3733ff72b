# Empty custom commands generated dependencies file for quad_control_genlisp.
# This may be replaced when dependencies are built.
