# Two commands do everything on a fresh Debian machine with a JDK 17, Maven, Python 3, g++ and CMake:
#   make demo    the main job, end to end          make test    every test
# `make help` lists the rest.
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.DEFAULT_GOAL := help

BUILD := build
JOBS := $(shell nproc)
PYTHON := scripts/python
RESULTS := $(BUILD)/test-results
ECHOWAY := $(BUILD)/bin/echoway

.PHONY: help
help: ## List the targets
	@grep -hE '^[a-z][a-z0-9-]*:.*## ' $(MAKEFILE_LIST) | sort | sed -E 's/:.*## /\t/' | column -t -s $$'\t'

.PHONY: setup
setup: ## Install the Debian packages that are missing (or say which command would)
	@scripts/install_packages.sh scripts/debian-packages.txt

.PHONY: core
core: setup ## Build the core, the simulator, the command line and the tests
	@cd core-native && cmake --preset release >/dev/null
	@cmake --build $(BUILD)/release -j$(JOBS)

DEMO := $(BUILD)/demo
DEMO_MAP := maps/torgersen-lab
DEMO_START := 1,1.83,1.52,90

.PHONY: demo
demo: core ## The main job: a walk through the lab, what the wearer hears, the error, a picture; then three levels in short
	@mkdir -p $(DEMO)
	@echo "A wearer walks through rooms 1, 2, 4, 2, 5 and 2 of the lab (simulated, furnished). They hear:"
	@$(ECHOWAY) simulate --building $(DEMO_MAP) --walk $(DEMO_MAP)/walks/thesis.walk --out $(DEMO)/walk
	@$(ECHOWAY) locate --building $(DEMO_MAP) --scans $(DEMO)/walk.scans.csv --motion $(DEMO)/walk.motion.csv \
	    --start $(DEMO_START) --track $(DEMO)/tracker.track.csv --cues $(DEMO)/cues.csv
	@echo "The tracker against the truth:"
	@$(ECHOWAY) score --building $(DEMO_MAP) --track $(DEMO)/tracker.track.csv --truth $(DEMO)/walk.truth.csv
	@echo "The thesis's method on the same echoes:"
	@$(ECHOWAY) locate --building $(DEMO_MAP) --scans $(DEMO)/walk.scans.csv --start $(DEMO_START) \
	    --method thesis --track $(DEMO)/thesis.track.csv | tail -n 1
	@$(ECHOWAY) score --building $(DEMO_MAP) --track $(DEMO)/thesis.track.csv --truth $(DEMO)/walk.truth.csv
	@$(PYTHON) scripts/plot_track.py --echoway $(ECHOWAY) --building $(DEMO_MAP) --truth $(DEMO)/walk.truth.csv \
	    --track $(DEMO)/tracker.track.csv --out $(DEMO)/walk.png
	@echo "Picture: $(DEMO)/walk.png"
	@echo
	@$(MAKE) --no-print-directory levels-summary

.PHONY: test-core
test-core: core ## The C++ tests
	@mkdir -p $(RESULTS)
	@ctest --test-dir $(BUILD)/release -j$(JOBS) --output-on-failure --progress --output-junit $(abspath $(RESULTS))/core.xml

.PHONY: test
test: test-core test-app ## Every test
	@$(PYTHON) scripts/count_tests.py $(RESULTS)

.PHONY: validate-simulator
validate-simulator: core ## Compare the simulated world with measurements: docs/simulator-validation.md
	@$(PYTHON) scripts/validate_simulator.py

BENCH_MAP := maps/torgersen-lab
.PHONY: bench
bench: core bench-app ## Error against run time (docs/error-against-run-time.md), the thesis's match, routes, bytes to estimate
	@$(BUILD)/bin/echoway_bench --benchmark_min_time=0.2
	@$(ECHOWAY) bench --building $(BENCH_MAP) --walks 40 --csv $(BUILD)/error-against-run-time.csv
	@$(PYTHON) scripts/plot_error_against_time.py $(BUILD)/error-against-run-time.csv --building $(BENCH_MAP) \
	    --plot docs/images/error-against-run-time.png --page docs/error-against-run-time.md

TRACKER_FIGURES := $(BUILD)/tracker-figures
.PHONY: tracker-figures
tracker-figures: core ## The tracker on many walks in two worlds: the tables of docs/tracker.md (ten minutes)
	@scripts/tracker_figures.sh $(BUILD)/bin/echoway_eval waves $(TRACKER_FIGURES)-waves.csv
	@scripts/tracker_figures.sh $(BUILD)/bin/echoway_eval rays $(TRACKER_FIGURES)-rays.csv
	@$(PYTHON) scripts/tracker_figures.py $(TRACKER_FIGURES)-waves.csv docs/tracker.md figures
	@$(PYTHON) scripts/tracker_figures.py $(TRACKER_FIGURES)-rays.csv docs/tracker.md rays

LEFT_OUT := $(BUILD)/left-out.json
.PHONY: leaving-out
leaving-out: core ## What rooms leave out of their echoes, and what that saves: the tables of docs/leaving-out.md (a minute)
	@$(BUILD)/bin/echoway_bench --benchmark_filter=^left_out --benchmark_repetitions=5 --benchmark_report_aggregates_only=true \
	    --benchmark_enable_random_interleaving=true --benchmark_out=$(LEFT_OUT) --benchmark_out_format=json
	@$(PYTHON) scripts/leaving_out.py $(LEFT_OUT) $(ECHOWAY) docs/leaving-out.md

.PHONY: clean
clean: ## Remove everything that was built
	rm -rf $(BUILD)

include core-native/verify.mk
include core-native/import/import.mk
include app/app.mk
include core-native/guidance.mk
include core-native/report.mk
