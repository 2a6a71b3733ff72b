# Empty custom commands generated dependencies file for gazebo_msgs_genlisp.
# This may be replaced when dependencies are built.
