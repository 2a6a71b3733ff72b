# Empty dependencies file for quad_experiment.
# This may be replaced when dependencies are built.
