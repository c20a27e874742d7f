package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Where things are: the project, its build folder, and what this machine keeps between clones. */
final class Workspace {
    final Path root;
    final Path build;
    final Path cache;
    final Lock lock;
    final Store store;

    Workspace(Path root, Path cache) throws IOException {
        this.root = root;
        this.cache = cache;
        build = root.resolve("build/app");
        lock = Lock.read(lockFile(root));
        store = new Store(cache);
        Files.createDirectories(build);
    }

    static Path lockFile(Path root) {
        return root.resolve("gradle/sdkless.lock");
    }

    /** Files of several sections of the lock, in their order. */
    List<Path> section(String... names) throws IOException {
        List<Lock.Entry> entries = new ArrayList<>();
        for (String name : names) entries.addAll(lock.section(name));
        return store.get(entries);
    }

    /** The one file of a module in a section. */
    Path file(String section, String module) throws IOException {
        Lock.Entry entry = lock.section(section).stream().filter(e -> e.module().equals(module)).findFirst()
                .orElseThrow(() -> new BuildFailure("section [" + section + "] of the lock has no " + module));
        return store.get(List.of(entry)).get(0);
    }

    /** Something that is made once a machine from a file of the store. */
    Path derived(String name, Path from) {
        return cache.resolve("derived").resolve(name).resolve(from.getParent().getFileName());
    }
}
