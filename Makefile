# make build | experiment | test | bench | doctor | clean. Each does its own set-up first.
SHELL := /bin/bash
# ROS's Python lives in /usr/bin; a pyenv or conda python must not come before it.
export PATH := /usr/bin:$(PATH)
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1
J ?= $(shell nproc)
CONFIG ?= config/thesis.yaml
OUT ?= results/$(basename $(notdir $(CONFIG)))
RUN := . build/devel/setup.sh &&

.PHONY: setup configure build tests test experiment bench doctor clean
.DEFAULT_GOAL := build

setup:
	@scripts/setup

configure: setup
	@[ -f build/Makefile ] || env -u ROS_MASTER_URI -u ROS_HOSTNAME -u ROS_IP cmake -S . -B build >build.log 2>&1 || { cat build.log; exit 1; }
	@rm -f build.log

build: configure
	@cmake --build build -j$(J) --target all -- --no-print-directory -s

tests: build
	@cmake --build build -j$(J) --target tests -- --no-print-directory -s

test: tests
	$(RUN) ROS_HOME=$(CURDIR)/build/ros_home ctest --test-dir build -j$(J) --output-on-failure

experiment: build
	$(RUN) scripts/experiment --config $(CONFIG) --out $(OUT) --force

bench: build
	$(RUN) scripts/bench

doctor:
	@scripts/doctor

clean:
	rm -rf build .deps results
