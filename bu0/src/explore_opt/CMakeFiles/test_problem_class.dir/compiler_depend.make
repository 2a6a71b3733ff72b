# Empty compiler generated dependencies file for test_problem_class.
# This may be replaced when dependencies are built.
