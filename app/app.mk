# The Android app without an Android SDK; the root Makefile includes this. See docs/building-the-app.md.
SDKLESS := tools/sdkless/run
JNI_BUILD := build/jni
CCACHE := $(shell command -v ccache)

.PHONY: core-jni fetch-app test-app screenshots apk check-gradle update-lock

# The JNI library for this machine, which the app's tests load.
core-jni:
	cmake -S core-native -B $(JNI_BUILD) -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
	    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O3 -g1 -DNDEBUG" $(if $(CCACHE),-DCMAKE_CXX_COMPILER_LAUNCHER=ccache) \
	    -DECHOWAY_JNI=ON -DECHOWAY_HOST=OFF >/dev/null
	cmake --build $(JNI_BUILD)

# Downloads what the app's tests need, to have it over with.
fetch-app:
	$(SDKLESS) fetch

test-app: core-jni
	$(SDKLESS) test $(CURDIR)/$(JNI_BUILD)/jni

# Draws the golden screenshots anew; look at every one before committing it.
screenshots: core-jni
	$(SDKLESS) screenshots $(CURDIR)/$(JNI_BUILD)/jni

apk:
	$(SDKLESS) apk

check-gradle:
	$(SDKLESS) check-gradle

# After a change to gradle/libs.versions.toml, gradle/sdkless-pins.txt or a script's dependencies.
update-lock:
	$(SDKLESS) update-lock
