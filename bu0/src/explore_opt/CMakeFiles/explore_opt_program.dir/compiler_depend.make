# Empty compiler generated dependencies file for explore_opt_program.
# This may be replaced when dependencies are built.
