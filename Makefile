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

.PHONY: test-core
test-core: core ## The C++ tests
	@mkdir -p $(RESULTS)
	@ctest --test-dir $(BUILD)/release -j$(JOBS) --output-on-failure --progress --output-junit $(abspath $(RESULTS))/core.xml

.PHONY: test
test: test-core ## Every test
	@$(PYTHON) scripts/count_tests.py $(RESULTS)

.PHONY: clean
clean: ## Remove everything that was built
	rm -rf $(BUILD)

include core-native/verify.mk
