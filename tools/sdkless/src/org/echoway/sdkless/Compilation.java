package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.ToolProvider;

/** Compiles the modules' main classes and the app's tests. */
final class Compilation {
    private final Workspace workspace;
    private final Kotlin kotlin;
    final Path usbApi;
    final Path core;
    final Path app;
    final Path tests;

    /** {@code variant}: the libraries whose resources the app is compiled with; their ids become constants in it. */
    Compilation(Workspace workspace, String variant) {
        this.workspace = workspace;
        kotlin = new Kotlin(workspace);
        usbApi = workspace.build.resolve("classes/usb-serial-api");
        core = workspace.build.resolve("classes/core-native");
        app = workspace.build.resolve("classes/" + variant + "/app");
        tests = workspace.build.resolve("classes/" + variant + "/app-test");
    }

    /** Main classes, against the libraries that the APK holds. */
    void main(Resources resources) throws IOException {
        Path platform = Platform.stub(workspace);
        List<Path> libraries = Libraries.of(workspace, "app").jars();
        compileUsbApi(platform);
        kotlin.compile(
                "core-native", sources(Layout.CORE, Layout.CORE.main()), with(libraries, platform), List.of(), core);
        kotlin.compile("app", sources(Layout.APP, Layout.APP.main()),
                with(libraries, core, usbApi, resources.rClasses(), platform), List.of(), app);
    }

    void tests(Resources resources) throws IOException {
        List<Path> libraries = Libraries.of(workspace, "app", "test").jars();
        kotlin.compile("app-test", sources(Layout.APP, Layout.APP.test()),
                with(libraries, app, core, usbApi, resources.rClasses(), Platform.stub(workspace)), List.of(app),
                tests);
    }

    private void compileUsbApi(Path platform) throws IOException {
        List<Path> sources = Tree.files(workspace.root.resolve(Layout.USB_SERIAL_API), ".java");
        new Stamp().files(sources).guard("javac usb-serial-api", usbApi, () -> {
            Tree.delete(usbApi);
            Files.createDirectories(usbApi);
            List<String> arguments =
                    new ArrayList<>(List.of("--release", "11", "-cp", platform.toString(), "-d", usbApi.toString()));
            sources.forEach(source -> arguments.add(source.toString()));
            int status = ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments.toArray(new String[0]));
            if (status != 0) throw new BuildFailure("compiling the stand-in for usb-serial failed");
        });
    }

    private List<Path> sources(Layout.Module module, List<String> folders) {
        return folders.stream().map(folder -> workspace.root.resolve(module.folder()).resolve(folder)).toList();
    }

    private static List<Path> with(List<Path> libraries, Path... more) {
        List<Path> all = new ArrayList<>(List.of(more));
        all.addAll(libraries);
        return all;
    }
}
