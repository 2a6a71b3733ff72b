# Empty dependencies file for quad_experiment_node.
# This may be replaced when dependencies are built.
