# Empty custom commands generated dependencies file for gazebo_msgs_gencpp.
# This may be replaced when dependencies are built.
