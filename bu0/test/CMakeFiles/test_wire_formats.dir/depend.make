# Empty dependencies file for test_wire_formats.
# This may be replaced when dependencies are built.
