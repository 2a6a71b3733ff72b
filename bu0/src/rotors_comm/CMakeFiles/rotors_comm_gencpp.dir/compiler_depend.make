# Empty custom commands generated dependencies file for rotors_comm_gencpp.
# This may be replaced when dependencies are built.
