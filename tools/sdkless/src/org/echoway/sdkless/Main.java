package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** The build of the Android app where there is no Android SDK. See docs/building-the-app.md. */
final class Main {
    private static final String USAGE = """
            usage: sdkless fetch                          download what the lock names
                   sdkless test NATIVE_DIR [CLASS...]     run the app's tests (all without CLASS)
                   sdkless screenshots NATIVE_DIR         record the golden screenshots anew
                   sdkless apk [NATIVE_DIR]               package, sign and verify the debug APK
                   sdkless bench NATIVE_DIR               time the way from bytes to an estimate
                   sdkless check-gradle                   check the Gradle scripts against Gradle's own API
                   sdkless update-lock                    resolve the catalog into the lock
            """;

    private Main() {}

    public static void main(String[] arguments) throws IOException {
        List<String> words = List.of(arguments);
        if (words.isEmpty()) {
            System.err.print(USAGE);
            System.exit(2);
        }
        Path root = Path.of(System.getProperty("sdkless.root"));
        try {
            run(root, words.get(0), words.subList(1, words.size()));
        } catch (BuildFailure failure) {
            System.err.println("sdkless: " + failure.getMessage());
            System.exit(1);
        }
    }

    private static void run(Path root, String command, List<String> rest) throws IOException {
        if (command.equals("update-lock")) {
            new UpdateLock(root).run();
            return;
        }
        Workspace workspace = new Workspace(root, Path.of(System.getProperty("sdkless.cache")));
        switch (command) {
            case "fetch" -> workspace.section("kotlin", "platform", "aapt2", "manifest", "app", "test");
            case "test" -> new Tests(workspace).run(
                    Path.of(rest.get(0)), List.of("-Droborazzi.test.verify=true"), rest.subList(1, rest.size()));
            case "screenshots" -> new Tests(workspace).run(
                    Path.of(rest.get(0)), List.of("-Droborazzi.test.record=true"),
                    List.of("org.echoway.app.ScreenshotTest"));
            case "apk" -> new Apk(workspace).build(rest.isEmpty() ? null : Path.of(rest.get(0)));
            case "bench" -> new Bench(workspace).run(Path.of(rest.get(0)));
            case "check-gradle" -> new GradleCheck(workspace).run();
            default -> throw new BuildFailure("no such command: " + command + "\n" + USAGE);
        }
    }
}
