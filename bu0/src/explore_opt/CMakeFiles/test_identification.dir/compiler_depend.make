# Empty compiler generated dependencies file for test_identification.
# This may be replaced when dependencies are built.
