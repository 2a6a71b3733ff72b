# Empty custom commands generated dependencies file for geometry_msgs_generate_messages_lisp.
# This may be replaced when dependencies are built.
