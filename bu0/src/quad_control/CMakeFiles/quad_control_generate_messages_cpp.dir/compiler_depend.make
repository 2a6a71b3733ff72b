# Empty custom commands generated dependencies file for quad_control_generate_messages_cpp.
# This may be replaced when dependencies are built.
