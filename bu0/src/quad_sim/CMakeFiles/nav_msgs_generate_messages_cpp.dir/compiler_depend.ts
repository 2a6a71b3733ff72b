# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for nav_msgs_generate_messages_cpp.
