# Empty compiler generated dependencies file for test_fifty_digits.
# This may be replaced when dependencies are built.
