# The Android app without an Android SDK; the root Makefile includes this. See docs/building-the-app.md.
SDKLESS := tools/sdkless/run
# The JNI library for this machine comes out of the core's own build.
JNI_DIR := $(CURDIR)/$(BUILD)/release/jni

.PHONY: fetch-app test-app screenshots bundled-walk apk bench-app check-gradle update-lock

fetch-app: ## Download what the app's tests need, to have it over with
	$(SDKLESS) fetch

test-app: core ## The app on Robolectric, with the core through JNI
	$(SDKLESS) test $(JNI_DIR)

# Draws the golden screenshots anew; look at every one before committing it.
screenshots: core ## Draw the golden screenshots anew
	$(SDKLESS) screenshots $(JNI_DIR)

# The truth beside the echoes is what the tests check the words against.
bundled-walk: core ## Simulate anew the walk that the app plays without a belt
	$(ECHOWAY) simulate --building maps/torgersen-lab --walk app/src/main/assets/walks/torgersen-lab.walk --out $(BUILD)/torgersen-lab
	mv $(BUILD)/torgersen-lab.scans.csv $(BUILD)/torgersen-lab.motion.csv app/src/main/assets/walks/
	mv $(BUILD)/torgersen-lab.truth.csv app/src/sharedTest/resources/walks/

# Native libraries for phones where ANDROID_NDK_HOME names an NDK.
NDK_TOOLCHAIN := $(wildcard $(ANDROID_NDK_HOME)/build/cmake/android.toolchain.cmake)
NDK_LIB := $(CURDIR)/$(BUILD)/ndk/lib

apk: ## The debug APK: packaged, signed, verified
ifneq ($(NDK_TOOLCHAIN),)
	for abi in arm64-v8a armeabi-v7a x86_64; do \
	    cmake -S core-native -B $(BUILD)/ndk/$$abi -G Ninja -DCMAKE_TOOLCHAIN_FILE=$(NDK_TOOLCHAIN) -DANDROID_ABI=$$abi \
	        -DANDROID_PLATFORM=26 -DANDROID_SUPPORT_FLEXIBLE_PAGE_SIZES=ON -DANDROID_STL=c++_static \
	        -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_LIBRARY_OUTPUT_DIRECTORY=$(NDK_LIB)/$$abi >/dev/null; \
	    cmake --build $(BUILD)/ndk/$$abi --target echoway_jni; \
	done
endif
	$(SDKLESS) apk $(if $(NDK_TOOLCHAIN),$(NDK_LIB))

# From the belt's bytes to an estimate in Kotlin.
bench-app: core ## Time the way from bytes to an estimate in Kotlin
	$(SDKLESS) bench $(JNI_DIR)

check-gradle: ## Type-check the Gradle scripts where no Gradle is
	$(SDKLESS) check-gradle

# After a change to gradle/libs.versions.toml, gradle/sdkless-pins.txt or a script's dependencies.
update-lock: ## Resolve the version catalog into the lock
	$(SDKLESS) update-lock
