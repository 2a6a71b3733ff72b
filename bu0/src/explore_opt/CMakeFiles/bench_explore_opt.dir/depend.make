# Empty dependencies file for bench_explore_opt.
# This may be replaced when dependencies are built.
