# Empty custom commands generated dependencies file for rotors_comm_genpy.
# This may be replaced when dependencies are built.
