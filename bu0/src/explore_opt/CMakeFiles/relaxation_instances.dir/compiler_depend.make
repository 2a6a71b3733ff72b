# Empty compiler generated dependencies file for relaxation_instances.
# This may be replaced when dependencies are built.
