# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for _quad_control_generate_messages_check_deps_FlightRecord.
