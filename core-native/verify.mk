# Numerical soundness: sanitizers, the same answer from every compiler and on every processor, fuzzers, and the pages that
# the checks write. None of these is part of `make test`, which runs the checks' quick parts.
VERIFY := $(BUILD)/bin/echoway_verify

.PHONY: setup-verify
setup-verify: setup
	@scripts/install_packages.sh scripts/debian-packages-verify.txt

# build-PRESET: configures and builds one of core-native/CMakePresets.json.
build-%: setup-verify
	@cd core-native && cmake --preset $* >/dev/null
	@cmake --build $(BUILD)/$* -j$(JOBS)

.PHONY: test-asan
test-asan: build-asan ## Every C++ test under the address, undefined-behaviour and leak sanitizers
	@ctest --test-dir $(BUILD)/asan -j$(JOBS) --output-on-failure --progress --timeout 600

.PHONY: check-libcxx
check-libcxx: build-libcxx ## The core with Clang 19 and libc++, as the NDK has them: compiles without a warning, stiff cases hold
	@$(BUILD)/libcxx/verify/echoway_verify stiff

.PHONY: test-arm64
test-arm64: build-arm64 ## The stiff cases on 64-bit ARM, under qemu-user
	@qemu-aarch64 -L /usr/aarch64-linux-gnu $(BUILD)/arm64/verify/echoway_verify stiff

.PHONY: test-arm32
test-arm32: build-arm32 ## The stiff cases on 32-bit ARM, under qemu-user
	@qemu-arm -L /usr/arm-linux-gnueabihf $(BUILD)/arm32/verify/echoway_verify stiff

.PHONY: stiff-page
stiff-page: core ## Write docs/stiff-cases.md
	@$(VERIFY) stiff-page > docs/stiff-cases.md

# Limits of one input: 1 s, 256 MB. One target after the other, SECONDS each; FUZZ="a b" picks targets.
SECONDS := 60
FUZZ := $(patsubst core-native/fuzz/targets/%.cpp,%,$(wildcard core-native/fuzz/targets/*.cpp))
FUZZ_LIMITS := -timeout=1 -malloc_limit_mb=256 -rss_limit_mb=768
.PHONY: fuzz
fuzz: build-fuzz ## Fuzz every target for SECONDS=60 each, starting from core-native/fuzz/corpus
	@for target in $(FUZZ); do \
	  echo "== $$target"; \
	  mkdir -p $(BUILD)/fuzz/found/$$target; \
	  TMPDIR=/dev/shm ASAN_OPTIONS=quarantine_size_mb=16 nice $(BUILD)/fuzz/fuzz/fuzz_$$target \
	    -max_total_time=$(SECONDS) $(FUZZ_LIMITS) -print_final_stats=1 -verbosity=0 -artifact_prefix=$(BUILD)/fuzz/$$target- \
	    $(BUILD)/fuzz/found/$$target core-native/fuzz/corpus/$$target core-native/fuzz/regressions/$$target; \
	done
