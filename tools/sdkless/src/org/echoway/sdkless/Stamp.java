package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;

/** Skips a step whose inputs are what they were: names and contents of files, and the words of its command. */
final class Stamp {
    private final MessageDigest digest = Store.newDigest();

    Stamp words(Object... words) {
        digest.update(Arrays.toString(words).getBytes());
        return this;
    }

    /** Files are taken by content, folders with everything below them; what does not exist counts as such. */
    Stamp files(List<Path> paths) throws IOException {
        for (Path path : paths) file(path);
        return this;
    }

    Stamp file(Path path) throws IOException {
        words(path.getFileName());
        for (Path each : Tree.files(path)) {
            words(path.relativize(each), Files.size(each));
            digest.update(Files.readAllBytes(each));
        }
        return this;
    }

    /** Large files of the store or of derived folders, whose path already tells their content. */
    Stamp paths(List<Path> paths) {
        return words(paths.toArray());
    }

    String value() {
        return HexFormat.of().formatHex(digest.digest());
    }

    interface Step {
        void run() throws IOException;
    }

    /** Runs the step unless {@code output} exists and was made from the same inputs. */
    void guard(String what, Path output, Step step) throws IOException {
        Path stamp = output.resolveSibling(output.getFileName() + ".stamp");
        String value = value();
        if (Files.exists(output) && Files.exists(stamp) && Files.readString(stamp).equals(value)) return;
        Files.deleteIfExists(stamp);
        Files.createDirectories(output.getParent());
        long start = System.nanoTime();
        step.run();
        System.out.printf("%-28s %5.1f s%n", what, (System.nanoTime() - start) / 1e9);
        Files.writeString(stamp, value);
    }
}
