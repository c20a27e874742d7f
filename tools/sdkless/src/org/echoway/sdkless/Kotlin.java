package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The Kotlin compiler with the plugins for Compose and for serialization (typed routes). */
final class Kotlin {
    static final String COMPILER = "org.jetbrains.kotlin.cli.jvm.K2JVMCompiler";
    private final Workspace workspace;

    Kotlin(Workspace workspace) {
        this.workspace = workspace;
    }

    /** Compiles {@code sources} into {@code output}; {@code friends} are classes whose `internal` members are seen. */
    void compile(String name, List<Path> sources, List<Path> classPath, List<Path> friends, Path output)
            throws IOException {
        List<Path> files = new ArrayList<>();
        for (Path folder : sources) files.addAll(Tree.files(folder, ".kt"));
        if (files.isEmpty()) throw new BuildFailure("no Kotlin sources in " + sources);
        Path compose = workspace.file("kotlin", "org.jetbrains.kotlin:kotlin-compose-compiler-plugin-embeddable");
        Path serialization =
                workspace.file("kotlin", "org.jetbrains.kotlin:kotlin-serialization-compiler-plugin-embeddable");

        List<String> arguments = new ArrayList<>(List.of("-no-stdlib", "-no-reflect", "-jvm-target", "17", "-Werror",
                "-module-name", name, "-Xplugin=" + compose, "-Xplugin=" + serialization, "-classpath",
                Exec.join(classPath), "-d", output.toString()));
        if (!friends.isEmpty()) arguments.add("-Xfriend-paths=" + Exec.join(friends).replace(':', ','));
        files.forEach(file -> arguments.add(file.toString()));

        Stamp stamp = new Stamp().words(arguments);
        stamp.files(files);
        for (Path each : classPath) {
            if (each.startsWith(workspace.build)) stamp.file(each);
        }
        stamp.guard("kotlinc " + name, output, () -> {
            Tree.delete(output);
            String said =
                    Exec.run("compiling " + name, Exec.java("1500m", workspace.section("kotlin"), COMPILER, arguments));
            if (!said.isBlank()) System.out.print(said);
            Files.createDirectories(output);
        });
    }
}
