# Empty custom commands generated dependencies file for quad_sim_uninstall.
# This may be replaced when dependencies are built.
