# Empty dependencies file for test_baselines.
# This may be replaced when dependencies are built.
