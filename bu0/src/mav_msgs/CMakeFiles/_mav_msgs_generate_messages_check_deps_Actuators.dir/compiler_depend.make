# Empty custom commands generated dependencies file for _mav_msgs_generate_messages_check_deps_Actuators.
# This may be replaced when dependencies are built.
