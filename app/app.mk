# The Android app without an Android SDK; the root Makefile includes this. See docs/building-the-app.md.
SDKLESS := tools/sdkless/run
# The JNI library for this machine comes out of the core's own build.
JNI_DIR := $(CURDIR)/$(BUILD)/release/jni

.PHONY: fetch-app test-app screenshots bundled-walk apk bench-app check-gradle update-lock

# Downloads what the app's tests need, to have it over with.
fetch-app:
	$(SDKLESS) fetch

test-app: core ## The app on Robolectric, with the core through JNI
	$(SDKLESS) test $(JNI_DIR)

# Draws the golden screenshots anew; look at every one before committing it.
screenshots: core ## Draw the golden screenshots anew
	$(SDKLESS) screenshots $(JNI_DIR)

# The echoes of the walk that the app plays without a belt. The truth beside them is what the tests check the words against.
bundled-walk: core
	$(ECHOWAY) simulate --building maps/torgersen-lab --walk app/src/main/assets/walks/torgersen-lab.walk --out $(BUILD)/torgersen-lab
	mv $(BUILD)/torgersen-lab.scans.csv $(BUILD)/torgersen-lab.motion.csv app/src/main/assets/walks/
	mv $(BUILD)/torgersen-lab.truth.csv app/src/sharedTest/resources/walks/

apk: ## The debug APK: packaged, signed, verified
	$(SDKLESS) apk

# From the belt's bytes to an estimate in Kotlin.
bench-app: core ## Time the way from bytes to an estimate in Kotlin
	$(SDKLESS) bench $(JNI_DIR)

check-gradle: ## Type-check the Gradle scripts where no Gradle is
	$(SDKLESS) check-gradle

# After a change to gradle/libs.versions.toml, gradle/sdkless-pins.txt or a script's dependencies.
update-lock:
	$(SDKLESS) update-lock
