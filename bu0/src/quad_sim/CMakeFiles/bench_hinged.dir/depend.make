# Empty dependencies file for bench_hinged.
# This may be replaced when dependencies are built.
