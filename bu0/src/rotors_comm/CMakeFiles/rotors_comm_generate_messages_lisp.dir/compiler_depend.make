# Empty custom commands generated dependencies file for rotors_comm_generate_messages_lisp.
# This may be replaced when dependencies are built.
