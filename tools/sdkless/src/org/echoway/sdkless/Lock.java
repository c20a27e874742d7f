package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The flat lock: every file the build uses, by section, with its SHA-256. Nothing is resolved at build time. */
record Lock(Map<String, List<Entry>> sections) {
    /** One file of a Maven repository. */
    record Entry(String group, String artifact, String version, String extension, String sha256) {
        String module() {
            return group + ":" + artifact;
        }

        String fileName() {
            return artifact + "-" + version + "." + extension;
        }

        @Override
        public String toString() {
            return group + ":" + artifact + ":" + version + "@" + extension + " " + sha256;
        }
    }

    static Lock read(Path file) throws IOException {
        Map<String, List<Entry>> sections = new LinkedHashMap<>();
        List<Entry> current = null;
        int number = 0;
        for (String line : Files.readAllLines(file)) {
            number++;
            String text = line.strip();
            if (text.isEmpty() || text.startsWith("#")) continue;
            if (text.startsWith("[") && text.endsWith("]")) {
                current = new ArrayList<>();
                sections.put(text.substring(1, text.length() - 1), current);
                continue;
            }
            String[] part = text.split("[:@ ]");
            if (current == null || part.length != 5 || part[4].length() != 64) {
                throw new BuildFailure(file + ":" + number + ": not 'group:artifact:version@type sha256': " + text);
            }
            current.add(new Entry(part[0], part[1], part[2], part[3], part[4]));
        }
        return new Lock(sections);
    }

    void write(Path file, String comment) throws IOException {
        List<String> lines = new ArrayList<>();
        comment.lines().forEach(line -> lines.add("# " + line));
        sections.forEach((name, entries) -> {
            lines.add("");
            lines.add("[" + name + "]");
            entries.stream().map(Entry::toString).sorted().forEach(lines::add);
        });
        Files.write(file, lines);
    }

    List<Entry> section(String name) {
        List<Entry> entries = sections.get(name);
        if (entries == null) throw new BuildFailure("the lock has no section [" + name + "]; run make update-lock");
        return entries;
    }
}
