# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
#
# The short way to everything. What is configured, and how, stands in CMakePresets.json.

PRESET ?= release
# Compilers at once. One takes up to 2 GB of memory.
JOBS ?= $(shell nproc)
BUILD := build/$(PRESET)
# Where make install puts everything; the Debian that make test-deb and test-debian make, and what the
# latter makes in it.
PREFIX ?= /usr/local
SUITE ?= bookworm
TARGET ?= demo

# The tests and the fit run threads of their own; those of the BLAS would only get in their way.
export OPENBLAS_NUM_THREADS ?= 1

.DEFAULT_GOAL := help
.PHONY: help demo portable test test-browser test-deep test-threads build docs bench format format-check tidy clean \
        packages test-packages configure report-modules report-assets fuzz kills soak \
        install uninstall deb test-library test-deb test-debian library-packages

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

demo: configure ## Build the command and fit a cloth to the pictures in data/lift
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target apps/clothfit
	$(BUILD)/apps/clothfit fit data/lift -o build/demo-run --force
	$(BUILD)/apps/clothfit evaluate build/demo-run --truth data/lift
	$(BUILD)/apps/clothfit draw build/demo-run -o build/demo.png --force
	$(BUILD)/apps/clothfit report build/demo-run -o build/demo.html --force

portable: packages ## Build a program for every x86-64 processor into build/portable/clothfit
	JOBS=$(JOBS) tools/portable build/portable/clothfit

install: packages library-packages ## Command, libclothfit and Python's package into PREFIX=/usr/local
	cmake --preset library -DCMAKE_INSTALL_PREFIX="$$(realpath -m $(PREFIX))"
	cmake --build --preset library --parallel $(JOBS) --target installed
	DESTDIR=$(DESTDIR) cmake --install build/library --strip
	[ -n "$(DESTDIR)" ] || [ "$$(id -u)" -ne 0 ] || ldconfig

uninstall: ## Remove what the last make install has installed
	xargs --delimiter='\n' rm --force --verbose < build/library/install_manifest.txt

deb: packages library-packages ## Debian packages for every x86-64 processor, into build/deb/packages
	JOBS=$(JOBS) MAINTAINER="$(MAINTAINER)" tools/make_deb build/deb/packages

test-library: test-packages packages library-packages ## The tests of libclothfit, of Python and of what is installed
	cmake --preset library
	cmake --build --preset library --parallel $(JOBS) --target installed clothfit_term_tests apps_tests small_diagnosis
	for folder in clothfit python apps; do \
	  ctest --test-dir build/library/tests/$$folder --output-on-failure --no-tests=error -j 2 || exit; \
	done

test-deb: library-packages test-packages ## Install and use the packages of make deb in a fresh Debian; needs root
	tests/clothfit/deb_test build/deb/packages build/deb/$(SUITE) $(SUITE)

test-debian: test-packages ## make TARGET=demo of the current commit in another Debian, SUITE=bookworm; needs root
	JOBS=$(JOBS) tools/test_on_debian $(SUITE) $(TARGET)

library-packages:
	@tools/install_packages library-packages.txt

# The tests in a browser are among them where Node.js, npm and Chromium are installed.
test: test-packages build ## Build everything and run all tests and source checks
	@tools/report_modules build/report-assets --where-possible
	ctest --preset $(PRESET)

test-browser: report-modules build ## The tests of the report's page, in Chromium, which this installs
	ctest --preset $(PRESET) -R '^(report_|hostile_page|export_gltf)' --output-on-failure

# CLOTHFIT_MUTATION_SEED=N has other inputs broken.
test-deep: test ## Sanitizers, 2000 broken inputs, 1000 fits in turn, then clang-tidy: hours
	CLOTHFIT_MUTATIONS=2000 CLOTHFIT_FITS=1000 ctest --preset $(PRESET) -R '^(MutatedInput|Memory)$$'
	$(MAKE) --no-print-directory test PRESET=asan-ubsan
	$(MAKE) --no-print-directory test-threads
	$(MAKE) --no-print-directory tidy

# Of all work that several threads share, and of what a signal stops.
THREADED := ParallelFor|Simulation|RolloutDerivative|SyntheticPictures|Renderer|TrackRecordingTest|LoadMask
THREADED := $(THREADED)|SoftSilhouette|CloudResiduals|CloudFitTest|NodeSums|Discretisation|Windows
THREADED := $(THREADED)|ShootingWindows|JointRollout|JointFit|RunJobs|FitRunnerTest|Diagnose|Report|Interrupted|Supernodes
test-threads: test-packages ## What several threads do, under the thread sanitizer
	$(MAKE) --no-print-directory build PRESET=tsan
	ctest --preset tsan -R '^($(THREADED))$$'

build: configure ## Build everything (PRESET=release, JOBS=all cores)
	cmake --build --preset $(PRESET) --parallel $(JOBS)

docs: configure ## Build the manual as a site, into build/manual/html
	@tools/install_packages docs/packages.txt
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target apps/clothfit
	tools/manual $(BUILD)/apps/clothfit build/manual

fuzz: ## Run each fuzzer of the readers for FUZZ_SECONDS=60 (tools/fuzz says more)
	@tools/install_packages packages.txt tests/packages.txt
	JOBS=$(JOBS) tools/fuzz

kills: build ## 40 kills of fits and 40 of diagnoses, resumed and compared (KILLS_ARGS=--fits 1)
	rm -rf build/kills
	tools/kills $(BUILD)/apps/clothfit build/kills --jobs $(JOBS) $(KILLS_ARGS)

soak: test-packages build ## Random commands, kills and full disks for SOAK_SECONDS=3600, invariants checked
	tools/soak $(BUILD)/apps/clothfit $(SOAK_SECONDS)

bench: configure ## Build and run the benchmarks (BENCH_ARGS=--benchmark_filter=...)
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target clothfit_benchmarks \
	  clothfit_silhouette_benchmarks clothfit_contact_benchmarks clothfit_job_benchmarks \
	  clothfit_pattern_search_schedule \
	  clothfit_wind_recovery clothfit_mesh_convergence
	$(BUILD)/tests/benchmarks/clothfit_benchmarks $(BENCH_ARGS)
	$(BUILD)/tests/benchmarks/clothfit_silhouette_benchmarks $(BENCH_ARGS)
	$(BUILD)/tests/benchmarks/clothfit_contact_benchmarks $(BENCH_ARGS)
	$(BUILD)/tests/benchmarks/clothfit_job_benchmarks $(BENCH_ARGS)
	$(BUILD)/tests/benchmarks/clothfit_pattern_search_schedule
	$(BUILD)/tests/benchmarks/clothfit_wind_recovery
	$(BUILD)/tests/benchmarks/clothfit_mesh_convergence

format: packages ## Lay out every tracked C++ file with clang-format
	tools/format

format-check: packages ## Fail where clang-format would change a file
	tools/format --check

tidy: packages ## Run clang-tidy over our sources: some minutes
	cmake --preset dev
	run-clang-tidy -quiet -j $(JOBS) -p build/dev -extra-arg=-Wno-error \
	  '$(CURDIR)/(autodiff_sim|tracking|fitting|apps|tests)/'

# What the page is bundled with and tested by. Node.js of elsewhere comes with an npm of its own.
report-modules:
	@{ command -v node && command -v npm && command -v chromium; } >/dev/null || \
	  tools/install_packages tests/apps/report/packages.txt
	tools/report_modules build/report-assets

# Only for work on the page itself: what it makes is kept in apps/report/dist.
report-assets: report-modules ## Bundle the page of `clothfit report` anew
	node apps/report/build.mjs build/report-assets/node_modules

clean: ## Remove everything that was built
	rm -rf build

test-packages: ## Install what tests, documentation and packaging need besides
	@tools/install_packages tests/packages.txt docs/packages.txt

packages: ## Install the Debian packages of packages.txt that are missing
	@tools/install_packages

configure: packages
	cmake --preset $(PRESET)
