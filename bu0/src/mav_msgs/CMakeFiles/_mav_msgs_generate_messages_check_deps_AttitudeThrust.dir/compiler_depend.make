# Empty custom commands generated dependencies file for _mav_msgs_generate_messages_check_deps_AttitudeThrust.
# This may be replaced when dependencies are built.
