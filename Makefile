# make build | experiment | report | test | batch | fuzz | bench | check | doctor | clean. What needs a build makes it first.
SHELL := /bin/bash
# ROS's Python lives in /usr/bin; a pyenv or conda python must not come before it.
export PATH := /usr/bin:$(PATH)
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1
J ?= $(shell nproc)
CONFIG ?= config/thesis.yaml
OUT ?= results/$(basename $(notdir $(CONFIG)))
RUN := . build/devel/setup.sh &&

.PHONY: setup extras configure build tests test experiment report batch bench check doctor clean fuzz
.DEFAULT_GOAL := build

setup:
	@scripts/setup --without-extras

# Tests and benchmarks also open notebooks, tables, a cluster and another solver.
extras:
	@scripts/setup

configure: setup
	@[ -f build/build.ninja ] || [ -f build/Makefile ] || env -u ROS_MASTER_URI -u ROS_HOSTNAME -u ROS_IP cmake -G Ninja -S . -B build >build.log 2>&1 || { cat build.log; exit 1; }
	@rm -f build.log

build: configure
	@cmake --build build -j$(J) --target all
	@touch build/.built

tests: extras build
	@cmake --build build -j$(J) --target tests

test: tests
	$(RUN) ROS_HOME=$(CURDIR)/build/ros_home ctest --test-dir build -j$(J) --output-on-failure

# Flies over ROS, prints the table and where this run lies among 200 seeds, makes the report; ends with the experiment's verdict (make's own
# exit code is 2 for any "no"; scripts/experiment alone passes on the precise one).
experiment: build
	@scripts/experiment --config $(CONFIG) --out $(OUT) --force; verdict=$$?; \
	case $$verdict in 0|3) build/devel/lib/quad_experiment/quad_experiment percentiles --results $(OUT) && \
	  scripts/report $(OUT) || exit $$?;; esac; \
	exit $$verdict

# The report of a run that is there already: make report OUT=results/mine
report: build
	@scripts/report $(OUT)

# The shipped Monte Carlo: 200 experiments on all cores, results/monte_carlo/results.csv, and what it says.
batch: build
	@build/devel/lib/quad_experiment/quad_experiment batch --spec config/monte_carlo.yaml --out results/monte_carlo --force

# A million broken inputs through explore_opt's entries, at the lowest priority.
fuzz: build
	@cmake --build build -j$(J) --target fuzz_inputs
	@cmake --build build --target fuzz

bench: extras build
	@$(RUN) scripts/bench

# The rules of the tree that need no build: layers, dependencies, launch files.
check: extras
	@for t in test_layers test_launch_files test_setup_and_doctor; do /usr/bin/python3 test/repo/$$t.py || exit $$?; done

doctor:
	@scripts/doctor

clean:
	rm -rf build .deps results
