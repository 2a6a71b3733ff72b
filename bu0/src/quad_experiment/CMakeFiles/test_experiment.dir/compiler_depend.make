# Empty compiler generated dependencies file for test_experiment.
# This may be replaced when dependencies are built.
