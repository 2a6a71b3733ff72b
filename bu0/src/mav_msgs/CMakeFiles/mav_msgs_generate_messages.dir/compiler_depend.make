# Empty custom commands generated dependencies file for mav_msgs_generate_messages.
# This may be replaced when dependencies are built.
