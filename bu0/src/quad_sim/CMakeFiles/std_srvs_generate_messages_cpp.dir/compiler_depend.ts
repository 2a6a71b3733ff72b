# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for std_srvs_generate_messages_cpp.
