# Empty custom commands generated dependencies file for fuzz.
# This may be replaced when dependencies are built.
