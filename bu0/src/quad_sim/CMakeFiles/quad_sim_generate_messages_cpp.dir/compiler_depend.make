# Empty custom commands generated dependencies file for quad_sim_generate_messages_cpp.
# This may be replaced when dependencies are built.
