# Empty compiler generated dependencies file for test_bad_problems.
# This may be replaced when dependencies are built.
