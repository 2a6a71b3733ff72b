# Empty compiler generated dependencies file for lockstep_rate.
# This may be replaced when dependencies are built.
