# Empty custom commands generated dependencies file for gazebo_msgs_genpy.
# This may be replaced when dependencies are built.
