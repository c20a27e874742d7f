package org.echoway.sdkless;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.zip.ZipFile;

/** Merged manifest, linked resources and R classes of the app with a set of libraries. */
final class Resources {
    static final int MIN_SDK = 26;
    static final int TARGET_SDK = 36;
    private static final String VERSION_NAME = "0.1.0";

    private final Workspace workspace;
    private final List<Path> aars;
    private final Path folder;

    /** {@code variant} names the folder below the build folder. */
    Resources(Workspace workspace, String variant, List<Path> aars) {
        this.workspace = workspace;
        this.aars = aars;
        folder = workspace.build.resolve(variant);
    }

    Path manifest() {
        return folder.resolve("AndroidManifest.xml");
    }

    Path linked() {
        return folder.resolve("resources.ap_");
    }

    Path rClasses() {
        return folder.resolve("R.jar");
    }

    /** Rules that keep what layouts and the manifest name, for R8. */
    Path keepRules() {
        return folder.resolve("aapt-rules.pro");
    }

    void build() throws IOException {
        Path module = workspace.root.resolve(Layout.APP.folder());
        Path source = module.resolve("src/main/AndroidManifest.xml");
        List<Path> resourceFolders = Layout.APP.resources().stream().map(module::resolve).toList();
        Path assets = new Assets(workspace).merge();
        Stamp stamp = new Stamp().words("resources 3").file(source).files(resourceFolders).file(assets).paths(aars);
        stamp.guard("resources " + folder.getFileName(), rClasses(), () -> {
            mergeManifest(source);
            link(compileAll(resourceFolders), assets);
            new RClasses(folder.resolve("R.txt"), aars).write(rClasses());
        });
    }

    private void mergeManifest(Path source) throws IOException {
        // Android's own build takes the package from the script's namespace; the merger alone wants it in the file.
        Path named = folder.resolve("source/AndroidManifest.xml");
        Files.createDirectories(named.getParent());
        Files.writeString(named,
                Files.readString(source).replaceFirst("<manifest ", "<manifest package=\"" + Layout.PACKAGE + "\" "));
        String libraries = aars.stream().map(aar -> aar.resolve("AndroidManifest.xml").toString())
                .collect(Collectors.joining(":"));
        List<String> arguments = new ArrayList<>(List.of("--main", named.toString(), "--libs", libraries, "--out",
                manifest().toString(), "--log", "WARNING", "--remove-tools-declarations"));
        for (String property : List.of("PACKAGE=" + Layout.PACKAGE, "MIN_SDK_VERSION=" + MIN_SDK,
                "TARGET_SDK_VERSION=" + TARGET_SDK, "VERSION_CODE=1", "VERSION_NAME=" + VERSION_NAME)) {
            arguments.addAll(List.of("--property", property));
        }
        Exec.run("merging manifests",
                Exec.java("512m", workspace.section("manifest"), "com.android.manifmerger.Merger", arguments));
    }

    private List<Path> compileAll(List<Path> resourceFolders) throws IOException {
        List<Path> compiled = new ArrayList<>();
        for (Path aar : aars) {
            Path resources = aar.resolve("res");
            if (!Files.isDirectory(resources)) continue;
            Path archive = aar.resolve("compiled-res.zip");
            if (!Files.exists(archive)) compile(resources, archive);
            compiled.add(archive);
        }
        for (Path resources : resourceFolders) {
            Path archive = folder.resolve(resources.getParent().getFileName() + "-res.zip");
            compile(resources, archive);
            compiled.add(archive);
        }
        return compiled;
    }

    private void compile(Path resources, Path archive) throws IOException {
        Path partial = Files.createTempDirectory(archive.getParent(), "part").resolve("out.zip");
        Exec.run("compiling " + resources,
                List.of(aapt2(workspace).toString(), "compile", "--dir", resources.toString(), "-o",
                        partial.toString()));
        Files.move(partial, archive, StandardCopyOption.REPLACE_EXISTING);
        Files.delete(partial.getParent());
    }

    private void link(List<Path> compiled, Path assets) throws IOException {
        List<String> command = new ArrayList<>(List.of(aapt2(workspace).toString(), "link", "-o", linked().toString(),
                "-I", tool(workspace, "prebuilt/android-framework.jar").toString(), "--manifest", manifest().toString(),
                "-A", assets.toString(), "--min-sdk-version", "" + MIN_SDK, "--target-sdk-version", "" + TARGET_SDK,
                "--version-code", "1", "--version-name", VERSION_NAME, "--auto-add-overlay", "--no-version-vectors",
                "--debug-mode", "--output-text-symbols", folder.resolve("R.txt").toString(), "--proguard",
                keepRules().toString()));
        for (Path archive : compiled) command.addAll(List.of("-R", archive.toString()));
        Exec.run("linking resources", command);
    }

    static Path aapt2(Workspace workspace) throws IOException {
        Path aapt2 = tool(workspace, "prebuilt/linux/aapt2");
        if (!aapt2.toFile().setExecutable(true)) throw new BuildFailure("cannot make executable: " + aapt2);
        return aapt2;
    }

    /** A file that apktool's library carries; taken out once a machine. */
    private static Path tool(Workspace workspace, String name) throws IOException {
        Path library = workspace.file("aapt2", "org.apktool:apktool-lib");
        Path target = workspace.derived("aapt2", library).resolve(name);
        if (Files.exists(target)) return target;
        Files.createDirectories(target.getParent());
        try (ZipFile zip = new ZipFile(library.toFile()); InputStream in = zip.getInputStream(zip.getEntry(name))) {
            Path partial = Files.createTempFile(target.getParent(), "part", "");
            Files.copy(in, partial, StandardCopyOption.REPLACE_EXISTING);
            Files.move(partial, target, StandardCopyOption.ATOMIC_MOVE);
        }
        return target;
    }
}
