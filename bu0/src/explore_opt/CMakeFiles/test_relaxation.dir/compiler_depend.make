# Empty compiler generated dependencies file for test_relaxation.
# This may be replaced when dependencies are built.
