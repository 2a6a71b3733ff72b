# Empty custom commands generated dependencies file for _quad_control_generate_messages_check_deps_FlightRecord.
# This may be replaced when dependencies are built.
