package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Runs the app's tests on this machine, with Robolectric for Android and the host-built JNI library for the core. */
final class Tests {
    private static final List<String> OPENED = List.of("java.lang", "java.lang.reflect", "java.util", "java.io",
            "java.net", "java.nio", "java.text", "jdk.internal.access", "java.security", "sun.nio.ch");

    private final Workspace workspace;

    Tests(Workspace workspace) {
        this.workspace = workspace;
    }

    /**
     * {@code properties}: system properties for the tests; {@code selected}: fully qualified classes, all when empty.
     */
    void run(Path nativeLibraries, List<String> properties, List<String> selected) throws IOException {
        Libraries libraries = Libraries.of(workspace, "app", "test");
        Resources resources = new Resources(workspace, "test", libraries.aars());
        resources.build();
        Compilation compilation = new Compilation(workspace, "test");
        compilation.main(resources);
        compilation.tests(resources);
        Path config = writeConfig(resources);

        List<Path> classPath = new ArrayList<>(List.of(compilation.tests, compilation.app, compilation.core,
                compilation.usbApi, config, resources.rClasses()));
        Path module = workspace.root.resolve(Layout.APP.folder());
        Layout.APP.testResources().forEach(folder -> classPath.add(module.resolve(folder)));
        classPath.addAll(libraries.jars());
        classPath.addAll(workspace.section("build")); // JUnit's launcher is there
        classPath.add(Platform.stub(workspace));

        List<String> command =
                new ArrayList<>(List.of(Exec.JAVA, "-Xmx2g", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
        for (String name : OPENED) command.add("--add-opens=java.base/" + name + "=ALL-UNNAMED");
        command.add("--add-opens=java.desktop/java.awt.font=ALL-UNNAMED");
        command.addAll(List.of("-Drobolectric.offline=true",
                "-Drobolectric.dependency.dir=" + Platform.instrumented(workspace).getParent(),
                "-Djava.library.path=" + nativeLibraries, "-Dechoway.maps=" + workspace.root.resolve("maps"),
                "-Dechoway.root=" + workspace.root));
        command.addAll(properties);
        command.addAll(List.of("-cp", Exec.join(classPath), "org.junit.platform.console.ConsoleLauncher", "execute",
                "--disable-banner", "--details=tree", "--disable-ansi-colors", "--include-engine=junit-vintage",
                "--reports-dir=" + reports()));
        if (selected.isEmpty()) {
            command.addAll(List.of("--scan-classpath=" + compilation.tests, "--include-classname=.*Test"));
        }
        for (String name : selected) command.addAll(List.of("--select-class", name));
        Tree.delete(reports());
        if (Exec.status(command) != 0) throw new BuildFailure("tests failed; reports are in " + reports());
    }

    private Path reports() {
        return workspace.root.resolve("build/test-results/app");
    }

    private Path writeConfig(Resources resources) throws IOException {
        Path folder = workspace.build.resolve("test-config");
        Path file = folder.resolve("com/android/tools/test_config.properties");
        Files.createDirectories(file.getParent());
        Files.writeString(file, "android_merged_manifest=" + resources.manifest()
                + "\nandroid_resource_apk=" + resources.linked()
                + "\nandroid_merged_assets=" + workspace.build.resolve("assets")
                + "\nandroid_custom_package=" + Layout.PACKAGE + "\n");
        return folder;
    }
}
