# Empty compiler generated dependencies file for bench_experiment.
# This may be replaced when dependencies are built.
