# Empty custom commands generated dependencies file for quad_sim_gencpp.
# This may be replaced when dependencies are built.
