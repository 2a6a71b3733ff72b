# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for quad_sim_generate_messages_lisp.
