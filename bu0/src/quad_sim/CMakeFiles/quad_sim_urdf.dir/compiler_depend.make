# Empty custom commands generated dependencies file for quad_sim_urdf.
# This may be replaced when dependencies are built.
