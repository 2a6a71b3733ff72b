# Empty compiler generated dependencies file for test_conversions.
# This may be replaced when dependencies are built.
