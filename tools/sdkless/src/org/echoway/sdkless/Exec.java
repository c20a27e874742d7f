package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Runs other programs. */
final class Exec {
    private Exec() {}

    static final String JAVA = Path.of(System.getProperty("java.home"), "bin", "java").toString();

    /** Runs a command with its output on ours; returns its exit status. */
    static int status(List<String> command) throws IOException {
        try {
            return new ProcessBuilder(command).inheritIO().start().waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BuildFailure("interrupted while running " + command.get(0));
        }
    }

    /** Runs a command quietly; its output becomes the failure's message. */
    static String run(String what, List<String> command) throws IOException {
        Path log = Files.createTempFile("sdkless", ".log");
        try {
            Process process =
                    new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile()).start();
            int status = process.waitFor();
            String output = Files.readString(log);
            if (status != 0) throw new BuildFailure(what + " failed:\n" + output);
            return output;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BuildFailure("interrupted: " + what);
        } finally {
            Files.deleteIfExists(log);
        }
    }

    /**
     * A main class in a JVM of its own, so that its memory and its exits are its own. Runs are short: the second
     * compiler would cost more than it gains.
     */
    static List<String> java(String memory, List<Path> classPath, String mainClass, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(JAVA, "-Xmx" + memory, "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC", "-cp", join(classPath), mainClass));
        command.addAll(arguments);
        return command;
    }

    static String join(List<Path> paths) {
        return paths.stream().map(Path::toString).collect(Collectors.joining(":"));
    }
}
