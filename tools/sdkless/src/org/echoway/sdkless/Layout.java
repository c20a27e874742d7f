package org.echoway.sdkless;

import java.util.List;

/**
 * Modules and source sets, as this build sees them. {@link GradleCheck} compares them with what the Gradle scripts say.
 */
final class Layout {
    private Layout() {}

    static final String PACKAGE = "org.echoway.app";
    static final String CORE_PACKAGE = "org.echoway.core";

    /** Gradle path of a module and the folders of its source sets, relative to the module. */
    record Module(String path, String namespace, List<String> main, List<String> test, List<String> testResources,
                  List<String> resources, List<String> assets) {
        String folder() {
            return path.substring(1);
        }
    }

    static final Module CORE = new Module(":core-native", CORE_PACKAGE, List.of("android/kotlin"), List.of(), List.of(),
            List.of(), List.of());

    static final Module APP = new Module(":app", PACKAGE, List.of("src/main/kotlin"),
            List.of("src/test/kotlin", "src/sharedTest/kotlin"),
            List.of("src/test/resources", "src/sharedTest/resources"),
            List.of("src/main/res"), List.of("src/main/assets", "../maps"));

    static final List<Module> MODULES = List.of(CORE, APP);

    /** Stand-in for the one library that Maven's default repository does not serve: its API, and no devices. */
    static final String USB_SERIAL_API = "tools/sdkless/usb-serial-api";
}
