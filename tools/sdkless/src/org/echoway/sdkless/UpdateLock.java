package org.echoway.sdkless;

import coursierapi.Cache;
import coursierapi.Dependency;
import coursierapi.Fetch;
import coursierapi.FetchResult;
import coursierapi.Module;
import coursierapi.ResolutionParams;
import coursierapi.error.CoursierError;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Resolves the catalog into the flat lock. The only place where a resolver runs. */
final class UpdateLock {
    private static final String COMMENT = """
            Every file that the build without an Android SDK uses, with its SHA-256. Made by `make update-lock` from
            gradle/libs.versions.toml, the dependencies of the Gradle scripts, and gradle/sdkless-pins.txt.""";
    /** These tools carry what is needed inside their own archive, or bring libraries that this build never calls. */
    private static final Set<String> ALONE = Set.of("bootstrap", "platform", "aapt2", "dex", "plugins");

    private final Path root;
    private final Catalog catalog;
    private final Map<String, String> pins = new TreeMap<>();
    private final List<String> excluded = new ArrayList<>();
    private final List<Catalog.Library> variants = new ArrayList<>();
    private final Map<Lock.Entry, Path> downloaded = new LinkedHashMap<>();

    UpdateLock(Path root) throws IOException {
        this.root = root;
        catalog = new Catalog(root.resolve("gradle/libs.versions.toml"));
        for (String line : Files.readAllLines(root.resolve("gradle/sdkless-pins.txt"))) {
            String text = line.strip();
            if (text.isEmpty() || text.startsWith("#")) continue;
            String name = text.substring(0, text.lastIndexOf(':'));
            String version = text.substring(text.lastIndexOf(':') + 1);
            if (text.startsWith("!")) excluded.add(text.substring(1));
            else if (text.startsWith("+")) variants.add(new Catalog.Library(text, name.substring(1), version));
            else pins.put(name, version);
        }
    }

    void run() throws IOException {
        Map<String, List<Lock.Entry>> sections = new LinkedHashMap<>();
        for (var tool : catalog.tools().entrySet()) {
            sections.put(tool.getKey(), resolve(tool.getValue(), Map.of(), !ALONE.contains(tool.getKey())));
        }
        // Tests and app run together, so that they are resolved together: the app's share is taken out of the whole.
        List<Catalog.Library> app = catalog.usedByApp(root);
        List<Catalog.Library> all = new ArrayList<>(app);
        all.addAll(catalog.usedByTests(root));
        all.addAll(variants);
        List<Lock.Entry> whole = phone(resolve(all, pins, true));
        Map<String, String> versions = new TreeMap<>(pins);
        whole.forEach(entry -> versions.put(entry.module(), entry.version()));
        Set<Lock.Entry> shipped = new LinkedHashSet<>(phone(resolve(app, versions, true)));
        shipped.retainAll(whole);
        sections.put("app", List.copyOf(shipped));
        sections.put("test", whole.stream().filter(entry -> !shipped.contains(entry)).toList());
        new Lock(sections).write(Workspace.lockFile(root), COMMENT);
    }

    private List<Lock.Entry> resolve(List<Catalog.Library> roots, Map<String, String> forced, boolean transitive)
            throws IOException {
        ResolutionParams parameters = ResolutionParams.create();
        for (var pin : forced.entrySet()) parameters = parameters.forceVersion(module(pin.getKey()), pin.getValue());
        for (String each : excluded) parameters = parameters.addExclusion(each.split(":")[0], each.split(":")[1]);
        Fetch fetch = Fetch.create().withCache(Cache.create()).withArtifactTypes(Store.TYPES)
                .withResolutionParams(parameters);
        for (Catalog.Library library : roots) {
            fetch.addDependencies(
                    Dependency.of(module(variant(library)), library.version()).withTransitive(transitive));
        }
        FetchResult result;
        try {
            result = fetch.fetchResult();
        } catch (CoursierError error) {
            throw new BuildFailure("cannot resolve: " + error.getMessage());
        }
        Set<Lock.Entry> entries = new LinkedHashSet<>();
        for (var artifact : result.getArtifacts()) {
            Path file = artifact.getValue().toPath();
            Lock.Entry entry = entry(artifact.getKey().getUrl(), file);
            downloaded.put(entry, file);
            entries.add(entry);
        }
        System.out.printf("%4d files from %s%n", entries.size(), roots.stream().map(Catalog.Library::alias).toList());
        return List.copyOf(entries);
    }

    /** Root modules of multi-platform libraries redirect to a variant in metadata that POMs do not carry. */
    private static String variant(Catalog.Library library) {
        String module = library.module();
        if (module.equals("app.cash.turbine:turbine")) return module + "-jvm";
        boolean redirects = module.startsWith("androidx.compose.") && !module.endsWith("-test-manifest");
        return redirects ? module + "-android" : module;
    }

    private static Module module(String name) {
        return Module.of(name.split(":")[0], name.split(":")[1]);
    }

    /** The tail of a Maven address is group/artifact/version/file. */
    private static Lock.Entry entry(String url, Path file) throws IOException {
        String path = url.substring(url.indexOf("/maven2/") + "/maven2/".length());
        String[] part = path.split("/");
        int n = part.length;
        String group = String.join(".", List.of(part).subList(0, n - 3));
        String extension = part[n - 1].substring(part[n - 1].lastIndexOf('.') + 1);
        return new Lock.Entry(group, part[n - 3], part[n - 2], extension, Store.sha256(file));
    }

    /** What goes on a class path: the AAR of a module that has both, nothing that is empty, no class twice. */
    private List<Lock.Entry> phone(List<Lock.Entry> entries) throws IOException {
        Set<String> aars = new LinkedHashSet<>();
        entries.stream().filter(entry -> entry.extension().equals("aar")).forEach(entry -> aars.add(entry.module()));
        List<Lock.Entry> kept = new ArrayList<>();
        Map<String, Lock.Entry> owners = new TreeMap<>();
        Set<String> twice = new LinkedHashSet<>();
        Set<String> hollow = new LinkedHashSet<>();
        for (Lock.Entry entry : entries) {
            if (entry.extension().equals("jar") && aars.contains(entry.module())) continue;
            List<String> contents = contents(downloaded.get(entry));
            if (contents.isEmpty()) {
                if (isRedirect(downloaded.get(entry)) && !hasVariant(entry, entries)) hollow.add(entry.toString());
                continue;
            }
            kept.add(entry);
            for (String name : contents) {
                boolean unique = name.endsWith(".class") && !name.equals("module-info.class");
                Lock.Entry other = unique ? owners.put(name, entry) : null;
                if (other != null) twice.add(other + " and " + entry);
            }
        }
        if (!twice.isEmpty()) {
            throw new BuildFailure(
                    "the same classes are in (pin or exclude one of each):\n" + String.join("\n", twice));
        }
        if (!hollow.isEmpty()) {
            throw new BuildFailure(
                    "only metadata, and no variant with classes (name one with +):\n" + String.join("\n", hollow));
        }
        kept.sort(Comparator.comparing(Lock.Entry::toString));
        return kept;
    }

    /** The root of a multi-platform library holds nothing but descriptions of its variants. */
    private static boolean isRedirect(Path file) throws IOException {
        try (ZipFile zip = new ZipFile(file.toFile())) {
            return zip.stream().anyMatch(entry -> isMetadata(entry.getName()));
        }
    }

    private static boolean isMetadata(String name) {
        return name.matches("\\w+Main/.*");
    }

    private static boolean hasVariant(Lock.Entry root, List<Lock.Entry> entries) {
        return List.of("-android", "-jvm").stream()
                .anyMatch(suffix -> entries.stream().anyMatch(entry -> entry.module().equals(root.module() + suffix)));
    }

    private static List<String> contents(Path file) throws IOException {
        List<String> names = new ArrayList<>();
        try (ZipFile zip = new ZipFile(file.toFile())) {
            for (ZipEntry entry : zip.stream().toList()) {
                String name = entry.getName();
                if (entry.isDirectory() || name.startsWith("META-INF/")) continue;
                if (name.equals("classes.jar")) {
                    names.addAll(classes(zip, entry));
                } else if (!isMetadata(name) && !isAarFrame(name)) {
                    names.add(name);
                }
            }
        }
        return names;
    }

    private static boolean isAarFrame(String name) {
        return Set.of("AndroidManifest.xml", "R.txt", "proguard.txt", "public.txt", "annotations.zip").contains(name);
    }

    private static List<String> classes(ZipFile zip, ZipEntry jar) throws IOException {
        List<String> names = new ArrayList<>();
        try (var in = new java.util.zip.ZipInputStream(zip.getInputStream(jar))) {
            for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
                if (entry.getName().endsWith(".class") && !entry.getName().startsWith("META-INF/")) {
                    names.add(entry.getName());
                }
            }
        }
        return names;
    }
}
