# Empty custom commands generated dependencies file for quad_sim_generate_messages_lisp.
# This may be replaced when dependencies are built.
