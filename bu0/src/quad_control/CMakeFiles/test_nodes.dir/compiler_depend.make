# Empty compiler generated dependencies file for test_nodes.
# This may be replaced when dependencies are built.
