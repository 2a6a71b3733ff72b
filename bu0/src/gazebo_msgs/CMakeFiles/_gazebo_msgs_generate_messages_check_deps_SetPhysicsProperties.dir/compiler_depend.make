# Empty custom commands generated dependencies file for _gazebo_msgs_generate_messages_check_deps_SetPhysicsProperties.
# This may be replaced when dependencies are built.
