# Empty compiler generated dependencies file for quad_experiment_program.
# This may be replaced when dependencies are built.
