package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Turns classes into dex files: libraries once a machine, the app's own each time, then both together. */
final class Dex {
    private static final String D8 = "com.android.tools.r8.D8";
    private final Workspace workspace;

    Dex(Workspace workspace) {
        this.workspace = workspace;
    }

    List<Path> build(List<Path> libraries, Resources resources, Compilation compilation) throws IOException {
        Path platform = Platform.stub(workspace);
        Stamp libraryStamp = new Stamp().words("dex 1").paths(libraries);
        Path libraryDex = workspace.cache.resolve("derived/dex").resolve(new Stamp().paths(libraries).value() + ".zip");
        libraryStamp.guard("dex of libraries", libraryDex, () -> d8(platform, libraries, List.of(), libraryDex, true));

        List<Path> own = new ArrayList<>(List.of(resources.rClasses()));
        for (Path classes : List.of(compilation.app, compilation.core, compilation.usbApi)) {
            own.addAll(Tree.files(classes, ".class"));
        }
        Path ownDex = workspace.build.resolve("apk/app-dex.zip");
        new Stamp().words("dex 1").files(own)
                .guard("dex of the app", ownDex, () -> d8(platform, own, libraries, ownDex, true));

        Path merged = workspace.build.resolve("apk/dex");
        new Stamp().file(libraryDex).file(ownDex).guard("dex together", merged, () -> {
            Tree.delete(merged);
            Files.createDirectories(merged);
            d8(platform, List.of(libraryDex, ownDex), List.of(), merged, false);
        });
        return Tree.files(merged, ".dex");
    }

    private void d8(Path platform, List<Path> inputs, List<Path> classPath, Path output, boolean intermediate)
            throws IOException {
        Files.createDirectories(output.getParent());
        List<String> arguments = new ArrayList<>(List.of("--debug", "--min-api", "" + Resources.MIN_SDK, "--lib",
                platform.toString(), "--lib", System.getProperty("java.home"), "--output", output.toString()));
        if (intermediate) arguments.add("--intermediate");
        for (Path path : classPath) arguments.addAll(List.of("--classpath", path.toString()));
        inputs.forEach(input -> arguments.add(input.toString()));
        // Too many class files for a command line: D8 reads them from a file.
        Path file = Files.createTempFile("d8", ".txt");
        Files.write(file, arguments);
        try {
            Exec.run("dexing", Exec.java("3g", workspace.section("dex"), D8, List.of("@" + file)));
        } finally {
            Files.delete(file);
        }
    }
}
