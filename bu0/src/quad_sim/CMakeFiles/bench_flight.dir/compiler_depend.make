# Empty compiler generated dependencies file for bench_flight.
# This may be replaced when dependencies are built.
