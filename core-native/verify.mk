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
	@ctest --test-dir $(BUILD)/asan -j$(JOBS) --output-on-failure --progress

# The hashes of the fixed walks from the release build are what every other build must give.
HASHES := $(BUILD)/track-hashes.txt
same-hashes = diff $(HASHES) <($(1)) && echo "the same tracks as GCC's release build: $(2)"
.PHONY: reference-hashes
reference-hashes: core
	@$(VERIFY) hash > $(HASHES)

.PHONY: check-hash
check-hash: reference-hashes build-verify-debug build-libcxx ## The same tracks from GCC and Clang, debug and release, one thread and four
	@$(call same-hashes,$(VERIFY) hash 4,four threads)
	@$(call same-hashes,$(BUILD)/verify-debug/verify/echoway_verify hash,GCC debug)
	@$(call same-hashes,$(BUILD)/libcxx/verify/echoway_verify hash,Clang and libc++)

.PHONY: check-libcxx
check-libcxx: build-libcxx ## The core with Clang 19 and libc++, as the NDK has them: compiles without a warning, stiff cases hold
	@$(BUILD)/libcxx/verify/echoway_verify stiff

QEMU_ARM64 := qemu-aarch64 -L /usr/aarch64-linux-gnu $(BUILD)/arm64/verify/echoway_verify
.PHONY: test-arm64
test-arm64: reference-hashes build-arm64 ## Stiff cases and track hash on 64-bit ARM, under qemu-user
	@$(QEMU_ARM64) stiff
	@$(call same-hashes,$(QEMU_ARM64) hash,64-bit ARM)

# 32-bit ARM shares neither libm's rounding nor the width of a long: most tracks differ in the last bit, but a last bit may
# send a resampling to the next particle, and from there a track in doubt parts from its twin by centimetres.
ARM32_BOUND_M := 0.2
QEMU_ARM32 := qemu-arm -L /usr/arm-linux-gnueabihf $(BUILD)/arm32/verify/echoway_verify
.PHONY: test-arm32
test-arm32: core build-arm32 ## Stiff cases on 32-bit ARM, under qemu-user; its tracks within a bound of the 64-bit ones
	@$(QEMU_ARM32) stiff
	@$(VERIFY) tracks > $(BUILD)/tracks-64.csv
	@$(QEMU_ARM32) tracks > $(BUILD)/tracks-arm32.csv
	@$(VERIFY) compare $(BUILD)/tracks-64.csv $(BUILD)/tracks-arm32.csv $(ARM32_BOUND_M)

.PHONY: stiff-page
stiff-page: core ## Write docs/stiff-cases.md
	@$(VERIFY) stiff-page > docs/stiff-cases.md

.PHONY: faults-page
faults-page: core ## Write docs/faults.md
	@$(VERIFY) faults-page > docs/faults.md

# One target after the other, SECONDS each; FUZZ="a b" picks targets.
SECONDS := 60
FUZZ := $(patsubst core-native/fuzz/targets/%.cpp,%,$(wildcard core-native/fuzz/targets/*.cpp))
.PHONY: fuzz
fuzz: build-fuzz ## Fuzz every target for SECONDS=60 each, starting from core-native/fuzz/corpus; adds to docs/fuzzing.md
	@$(PYTHON) scripts/fuzz.py --build $(BUILD)/fuzz --core core-native --page docs/fuzzing.md --seconds $(SECONDS) $(FUZZ)
