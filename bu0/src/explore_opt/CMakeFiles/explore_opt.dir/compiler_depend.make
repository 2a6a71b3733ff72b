# Empty compiler generated dependencies file for explore_opt.
# This may be replaced when dependencies are built.
