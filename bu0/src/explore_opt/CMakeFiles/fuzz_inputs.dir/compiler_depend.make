# Empty compiler generated dependencies file for fuzz_inputs.
# This may be replaced when dependencies are built.
