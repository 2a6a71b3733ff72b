# Empty compiler generated dependencies file for test_ros_surface.
# This may be replaced when dependencies are built.
