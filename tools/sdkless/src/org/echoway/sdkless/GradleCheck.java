package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Checks the Gradle scripts where no Gradle is: each is compiled against Gradle's and the Android Gradle Plugin's own
 * API, with small stand-ins for what Gradle generates, and their modules and folders are compared with {@link Layout}.
 */
final class GradleCheck {
    private static final Pattern INCLUDE = Pattern.compile("include\\(\"([^\"]+)\"\\)");
    private static final Pattern SOURCES = Pattern.compile("(kotlin|assets|resources)\\.directories \\+= \"([^\"]+)\"");
    private static final Pattern NAMESPACE = Pattern.compile("namespace = \"([^\"]+)\"");

    private final Workspace workspace;
    private final Catalog catalog;

    GradleCheck(Workspace workspace) throws IOException {
        this.workspace = workspace;
        catalog = new Catalog(workspace.root.resolve("gradle/libs.versions.toml"));
    }

    void run() throws IOException {
        // Everything that the catalog names, plugins included, is there to be had (a test compares lock and catalog).
        workspace.section(workspace.lock.sections().keySet().toArray(new String[0]));
        compareModules();
        for (Layout.Module module : Layout.MODULES) compareFolders(module);
        compareSdkVersions();
        Path sources = workspace.build.resolve("check-gradle/src");
        Tree.delete(sources);
        Files.createDirectories(sources);
        Files.copy(workspace.root.resolve("tools/sdkless/check-gradle/Prelude.kt"), sources.resolve("Prelude.kt"));
        Files.writeString(sources.resolve("Libs.kt"), accessors());
        wrap(sources, "settings.gradle.kts", "org.gradle.api.initialization.Settings", "");
        wrap(sources, "build.gradle.kts", "Project", "");
        wrap(sources, "app/build.gradle.kts", "Project", "ApplicationExtension");
        wrap(sources, "core-native/build.gradle.kts", "Project", "LibraryExtension");
        compile(sources);
        System.out.println(
                "Gradle scripts: names and types are right; "
                        + "modules, folders and versions are those of the other build");
    }

    private void compareModules() throws IOException {
        Set<String> included = all(INCLUDE, workspace.root.resolve("settings.gradle.kts"), 1);
        Set<String> built = new TreeSet<>(Layout.MODULES.stream().map(Layout.Module::path).toList());
        expect("settings.gradle.kts: modules", built, included);
    }

    private void compareFolders(Layout.Module module) throws IOException {
        Path script = workspace.root.resolve(module.folder()).resolve("build.gradle.kts");
        expect(script + ": namespace", Set.of(module.namespace()), all(NAMESPACE, script, 1));
        Map<String, Set<String>> extra = new TreeMap<>();
        Matcher matcher = SOURCES.matcher(Files.readString(script));
        while (matcher.find()) extra.computeIfAbsent(matcher.group(1), kind -> new TreeSet<>()).add(matcher.group(2));
        // Folders that Gradle knows without being told need no line in a script.
        Set<String> known = Set.of("src/main/kotlin", "src/test/kotlin", "src/main/assets", "src/test/resources");
        expect(script + ": kotlin", without(known, module.main(), module.test()),
                extra.getOrDefault("kotlin", Set.of()));
        expect(script + ": assets", without(known, module.assets()), extra.getOrDefault("assets", Set.of()));
        expect(script + ": test resources", without(known, module.testResources()),
                extra.getOrDefault("resources", Set.of()));
    }

    private void compareSdkVersions() throws IOException {
        expect("catalog: minSdk", Set.of("" + Resources.MIN_SDK), Set.of(catalog.version("minSdk")));
        expect("catalog: targetSdk", Set.of("" + Resources.TARGET_SDK), Set.of(catalog.version("targetSdk")));
        int compileSdk = Integer.parseInt(catalog.version("compileSdk"));
        Pattern required = Pattern.compile("minCompileSdk=(\\d+)");
        for (Path aar : Libraries.of(workspace, "app", "test").aars()) {
            Path metadata = aar.resolve("META-INF/com/android/build/gradle/aar-metadata.properties");
            if (!Files.exists(metadata)) continue;
            for (String level : all(required, metadata, 1)) {
                if (Integer.parseInt(level) <= compileSdk) continue;
                String name = Files.readString(aar.resolve("AndroidManifest.xml"))
                        .replaceAll("(?s).*package=\"([^\"]+)\".*", "$1");
                throw new BuildFailure("catalog: compileSdk is " + compileSdk + ", but " + name + " needs " + level);
            }
        }
    }

    private static void expect(String what, Set<String> built, Set<String> said) {
        if (!new TreeSet<>(built).equals(new TreeSet<>(said))) {
            throw new BuildFailure(what + ": Gradle has " + said + ", the build without an SDK has " + built);
        }
    }

    @SafeVarargs
    private static Set<String> without(Set<String> known, List<String>... folders) {
        Set<String> rest = new TreeSet<>();
        for (List<String> each : folders) rest.addAll(each);
        rest.removeAll(known);
        return rest;
    }

    private static Set<String> all(Pattern pattern, Path file, int group) throws IOException {
        Set<String> found = new TreeSet<>();
        Matcher matcher = pattern.matcher(Files.readString(file));
        while (matcher.find()) found.add(matcher.group(group));
        return found;
    }

    /** A script as the body of a function on its receiver, with its lines where they were. */
    private void wrap(Path sources, String script, String receiver, String extension) throws IOException {
        String name = script.replaceAll("\\W", "_");
        String android =
                extension.isEmpty() ? "" : " private fun Project.android(block: " + extension + ".() -> Unit) = Unit;";
        String head = "import com.android.build.api.dsl.*; import org.gradle.api.*; "
                + "import org.gradle.api.initialization.resolve.*;"
                + android + " fun " + receiver + "." + name + "() { ";
        String body = Files.readString(workspace.root.resolve(script));
        Files.writeString(sources.resolve(name + ".kt"), head + body + "}\n");
    }

    /** The catalog's accessors as Gradle generates them: dashes nest. */
    private String accessors() {
        Node root = new Node();
        for (Catalog.Library library : catalog.libraries()) {
            root.add(library.alias(), "org.gradle.api.artifacts.MinimalExternalModuleDependency");
        }
        for (String plugin : catalog.plugins()) root.add("plugins-" + plugin, "org.gradle.plugin.use.PluginDependency");
        for (String version : catalog.versionNames()) root.add("versions-" + version, "String");
        return "object libs {\n" + root.body() + "}\n";
    }

    private static final class Node {
        private final Map<String, Node> children = new TreeMap<>();
        private String type;

        void add(String alias, String leaf) {
            Node node = this;
            for (String part : alias.split("-")) node = node.children.computeIfAbsent(part, name -> new Node());
            node.type = leaf;
        }

        String body() {
            StringBuilder text = new StringBuilder();
            children.forEach((name, child) -> {
                if (child.children.isEmpty()) {
                    text.append("val ").append(name).append(": org.gradle.api.provider.Provider<").append(child.type)
                            .append("> get() = TODO()\n");
                } else {
                    String itself = child.type == null ? ""
                            : " : org.gradle.api.provider.Provider<" + child.type + "> by TODO()";
                    text.append("object ").append(name).append(itself)
                            .append(" {\n").append(child.body()).append("}\n");
                }
            });
            return text.toString();
        }
    }

    private void compile(Path sources) throws IOException {
        List<Path> api = new ArrayList<>();
        for (Path file : workspace.section("gradle")) {
            if (!file.getFileName().toString().contains("compiler-plugin-embeddable")) api.add(file);
        }
        List<String> arguments = new ArrayList<>(List.of("-no-stdlib", "-no-reflect", "-jvm-target", "17", "-nowarn",
                plugin("sam-with-receiver"),
                "-P", "plugin:org.jetbrains.kotlin.samWithReceiver:annotation=org.gradle.api.HasImplicitReceiver",
                plugin("assignment"),
                "-P",
                "plugin:org.jetbrains.kotlin.assignment:annotation=org.gradle.api.SupportsKotlinAssignmentOverloading",
                "-classpath", Exec.join(api), "-d", workspace.build.resolve("check-gradle/classes").toString()));
        for (Path file : Tree.files(sources, ".kt")) arguments.add(file.toString());
        Exec.run("checking the Gradle scripts",
                Exec.java("1500m", workspace.section("kotlin"), Kotlin.COMPILER, arguments));
    }

    private String plugin(String name) throws IOException {
        String module = "org.jetbrains.kotlin:kotlin-" + name + "-compiler-plugin-embeddable";
        return "-Xplugin=" + workspace.file("gradle", module);
    }
}
