# Empty dependencies file for test_baseline_signals.
# This may be replaced when dependencies are built.
