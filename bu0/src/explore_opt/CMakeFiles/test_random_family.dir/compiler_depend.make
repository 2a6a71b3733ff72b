# Empty compiler generated dependencies file for test_random_family.
# This may be replaced when dependencies are built.
