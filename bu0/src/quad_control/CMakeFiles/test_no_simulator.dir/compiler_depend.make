# Empty compiler generated dependencies file for test_no_simulator.
# This may be replaced when dependencies are built.
