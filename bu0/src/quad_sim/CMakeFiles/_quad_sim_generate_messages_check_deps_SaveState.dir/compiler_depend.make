# Empty custom commands generated dependencies file for _quad_sim_generate_messages_check_deps_SaveState.
# This may be replaced when dependencies are built.
