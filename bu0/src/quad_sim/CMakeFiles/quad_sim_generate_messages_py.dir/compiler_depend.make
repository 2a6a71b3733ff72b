# Empty custom commands generated dependencies file for quad_sim_generate_messages_py.
# This may be replaced when dependencies are built.
