# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for _gazebo_msgs_generate_messages_check_deps_ModelStates.
