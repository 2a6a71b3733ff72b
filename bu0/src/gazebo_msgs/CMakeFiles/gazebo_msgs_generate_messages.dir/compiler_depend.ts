# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for gazebo_msgs_generate_messages.
