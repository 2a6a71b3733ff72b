# Empty compiler generated dependencies file for time_manager_node.
# This may be replaced when dependencies are built.
