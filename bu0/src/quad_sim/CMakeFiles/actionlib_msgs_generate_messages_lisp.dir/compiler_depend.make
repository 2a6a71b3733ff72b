# Empty custom commands generated dependencies file for actionlib_msgs_generate_messages_lisp.
# This may be replaced when dependencies are built.
