# Empty compiler generated dependencies file for test_newton_euler.
# This may be replaced when dependencies are built.
