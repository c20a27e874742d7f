package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.tomlj.Toml;
import org.tomlj.TomlParseResult;
import org.tomlj.TomlTable;

/** Gradle's version catalog, and which of its libraries the scripts use for what. */
final class Catalog {
    /** Served by another repository than Maven's default; the SDK-less build has a stand-in for its API. */
    static final String ELSEWHERE = "usb-serial";
    private static final String TOOL = "sdkless-";
    private static final Pattern DEPENDENCY = Pattern.compile("(\\w+)\\(libs\\.([\\w.]+)\\)");
    private static final List<String> MAIN = List.of("implementation", "api");
    private static final List<String> TEST = List.of("testImplementation", "debugImplementation");

    /** A library of the catalog. */
    record Library(String alias, String module, String version) {}

    private final Map<String, Library> libraries = new TreeMap<>();
    private final TomlParseResult toml;

    Catalog(Path file) throws IOException {
        toml = Toml.parse(file);
        if (toml.hasErrors()) throw new BuildFailure(file + ": " + toml.errors().get(0));
        TomlTable table = toml.getTable("libraries");
        for (String alias : table.keySet()) {
            TomlTable library = table.getTable(alias);
            libraries.put(alias, new Library(alias, library.getString("module"), version(library, alias)));
        }
    }

    private String version(TomlTable entry, String alias) {
        String reference = entry.getString("version.ref");
        String version = reference == null ? null : version(reference);
        if (version == null) {
            throw new BuildFailure("catalog entry " + alias + " has no version.ref that [versions] knows");
        }
        return version;
    }

    String version(String name) {
        return toml.getTable("versions").getString(name);
    }

    List<String> versionNames() {
        return List.copyOf(toml.getTable("versions").keySet());
    }

    List<String> plugins() {
        return List.copyOf(toml.getTable("plugins").keySet());
    }

    List<Library> libraries() {
        return List.copyOf(libraries.values());
    }

    /** Sections of the lock that hold tools, each with its roots. */
    Map<String, List<Library>> tools() {
        Map<String, List<Library>> sections = new TreeMap<>();
        for (Library library : libraries.values()) {
            if (!library.alias().startsWith(TOOL)) continue;
            sections.computeIfAbsent(library.alias().split("-")[1], name -> new ArrayList<>()).add(library);
        }
        return sections;
    }

    List<Library> usedByApp(Path root) throws IOException {
        return used(root, MAIN);
    }

    List<Library> usedByTests(Path root) throws IOException {
        return used(root, TEST);
    }

    private List<Library> used(Path root, List<String> configurations) throws IOException {
        List<Library> used = new ArrayList<>();
        for (Layout.Module module : Layout.MODULES) {
            Path script = root.resolve(module.folder()).resolve("build.gradle.kts");
            Matcher matcher = DEPENDENCY.matcher(Files.readString(script));
            while (matcher.find()) {
                if (!configurations.contains(matcher.group(1))) continue;
                String alias = matcher.group(2).replace('.', '-');
                Library library = libraries.get(alias);
                if (library == null) throw new BuildFailure(script + ": the catalog has no library " + alias);
                if (!alias.equals(ELSEWHERE) && !used.contains(library)) used.add(library);
            }
        }
        return used;
    }
}
