package org.echoway.sdkless;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Libraries ready for use: jars as they are, AARs unpacked once a machine. */
record Libraries(List<Path> jars, List<Path> aars) {
    static Libraries of(Workspace workspace, String... sections) throws IOException {
        List<Path> jars = new ArrayList<>();
        List<Path> aars = new ArrayList<>();
        for (Path file : workspace.section(sections)) {
            if (!file.toString().endsWith(".aar")) {
                jars.add(file);
                continue;
            }
            Path folder = workspace.derived("aar", file);
            if (!Files.exists(folder)) unpack(file, folder);
            aars.add(folder);
            if (Files.exists(folder.resolve("classes.jar"))) jars.add(folder.resolve("classes.jar"));
            jars.addAll(Tree.files(folder.resolve("libs"), ".jar"));
        }
        return new Libraries(jars, aars);
    }

    private static void unpack(Path archive, Path folder) throws IOException {
        Files.createDirectories(folder.getParent());
        Path partial = Files.createTempDirectory(folder.getParent(), "part");
        try (ZipFile zip = new ZipFile(archive.toFile())) {
            for (Enumeration<? extends ZipEntry> all = zip.entries(); all.hasMoreElements(); ) {
                ZipEntry entry = all.nextElement();
                Path target = partial.resolve(entry.getName()).normalize();
                if (!target.startsWith(partial)) {
                    throw new BuildFailure(archive + " holds a path that leads outside: " + entry.getName());
                }
                if (entry.isDirectory()) continue;
                Files.createDirectories(target.getParent());
                try (InputStream in = zip.getInputStream(entry)) {
                    Files.copy(in, target);
                }
            }
        }
        try {
            Files.move(partial, folder);
        } catch (java.nio.file.FileAlreadyExistsException | java.nio.file.DirectoryNotEmptyException madeMeanwhile) {
            Tree.delete(partial);
        }
    }
}
