# Empty custom commands generated dependencies file for _rotors_comm_generate_messages_check_deps_RecordRosbag.
# This may be replaced when dependencies are built.
