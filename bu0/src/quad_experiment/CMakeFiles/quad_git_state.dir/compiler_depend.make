# Empty custom commands generated dependencies file for quad_git_state.
# This may be replaced when dependencies are built.
