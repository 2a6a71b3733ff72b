# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for trajectory_msgs_generate_messages_py.
