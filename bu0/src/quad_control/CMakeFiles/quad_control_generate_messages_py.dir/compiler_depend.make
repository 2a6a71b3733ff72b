# Empty custom commands generated dependencies file for quad_control_generate_messages_py.
# This may be replaced when dependencies are built.
