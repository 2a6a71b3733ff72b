# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for rotors_comm_generate_messages_lisp.
