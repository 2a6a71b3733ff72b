# Empty dependencies file for test_sim_node.
# This may be replaced when dependencies are built.
