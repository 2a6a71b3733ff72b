# Empty dependencies file for test_wallclock.
# This may be replaced when dependencies are built.
