# Empty compiler generated dependencies file for geometric_controller.
# This may be replaced when dependencies are built.
