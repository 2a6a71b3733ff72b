# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for _rotors_comm_generate_messages_check_deps_WindSpeed.
