# Empty custom commands generated dependencies file for gazebo_msgs_generate_messages.
# This may be replaced when dependencies are built.
