package org.echoway.sdkless;

import coursierapi.Cache;
import coursierapi.Dependency;
import coursierapi.Fetch;
import coursierapi.FetchResult;
import coursierapi.error.CoursierError;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Files of the lock on this machine, by content: {@code <cache>/files/<sha256>/<name>}. A file gets in only when its
 * hash is right, so that being there is proof enough. Coursier downloads what is missing, from Maven's default
 * repository.
 */
final class Store {
    /** What a dependency of the phone or the host may be packed as. */
    static final Set<String> TYPES = Set.of("jar", "aar", "bundle");

    private final Path files;

    Store(Path cache) {
        files = cache.resolve("files");
    }

    /** Paths of the entries, in their order; downloads what is missing. */
    List<Path> get(List<Lock.Entry> entries) throws IOException {
        List<Lock.Entry> missing = entries.stream().filter(entry -> !Files.exists(path(entry))).toList();
        if (!missing.isEmpty()) System.out.println("fetching " + missing.size() + " files");
        for (List<Lock.Entry> round : oneVersionEach(missing)) download(round);
        return entries.stream().map(this::path).toList();
    }

    Path path(Lock.Entry entry) {
        return files.resolve(entry.sha256()).resolve(entry.fileName());
    }

    /**
     * The entries in as few lists as it takes until none has two versions of a module: of what is asked for together
     * Coursier fetches the newest version alone, and the Gradle scripts need other ones than the app.
     */
    private static List<List<Lock.Entry>> oneVersionEach(List<Lock.Entry> entries) {
        Map<String, List<String>> versions = new HashMap<>();
        List<List<Lock.Entry>> rounds = new ArrayList<>();
        for (Lock.Entry entry : entries) {
            List<String> known = versions.computeIfAbsent(entry.module(), module -> new ArrayList<>());
            if (!known.contains(entry.version())) known.add(entry.version());
            int round = known.indexOf(entry.version());
            while (rounds.size() <= round) rounds.add(new ArrayList<>());
            rounds.get(round).add(entry);
        }
        return rounds;
    }

    private void download(List<Lock.Entry> missing) throws IOException {
        Fetch fetch = Fetch.create().withCache(Cache.create()).withArtifactTypes(TYPES);
        for (Lock.Entry entry : missing) {
            fetch.addDependencies(Dependency.of(entry.group(), entry.artifact(), entry.version())
                    .withTransitive(false).withType(entry.extension()));
        }
        FetchResult result;
        try {
            result = fetch.fetchResult();
        } catch (CoursierError error) {
            throw new BuildFailure("cannot fetch what the lock names: " + error.getMessage());
        }
        List<Path> got = new ArrayList<>();
        result.getArtifacts().forEach(artifact -> got.add(artifact.getValue().toPath()));
        for (Lock.Entry entry : missing) admit(entry, got);
    }

    private void admit(Lock.Entry entry, List<Path> candidates) throws IOException {
        for (Path candidate : candidates) {
            if (!candidate.getFileName().toString().equals(entry.fileName())) continue;
            if (!sha256(candidate).equals(entry.sha256())) continue;
            Path target = path(entry);
            Files.createDirectories(target.getParent());
            Path partial = Files.createTempFile(target.getParent(), "part", "");
            Files.copy(candidate, partial, StandardCopyOption.REPLACE_EXISTING);
            Files.move(partial, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            return;
        }
        throw new BuildFailure("no file with the lock's hash could be fetched for " + entry);
    }

    static String sha256(Path file) throws IOException {
        MessageDigest digest = newDigest();
        try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
            in.transferTo(java.io.OutputStream.nullOutputStream());
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    static MessageDigest newDigest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }
}
