# Empty compiler generated dependencies file for quad_sim_node.
# This may be replaced when dependencies are built.
