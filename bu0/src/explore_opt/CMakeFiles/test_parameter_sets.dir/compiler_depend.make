# Empty compiler generated dependencies file for test_parameter_sets.
# This may be replaced when dependencies are built.
