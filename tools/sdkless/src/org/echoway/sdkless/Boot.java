package org.echoway.sdkless;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;

/**
 * First stage: writes down the classpath of the second (arguments: lock, cache, file to write). Compiled with
 * coursier's interface alone, it fetches the lock's section [build], which is what the rest of this program is compiled
 * with.
 */
final class Boot {
    public static void main(String[] args) throws Exception {
        try {
            List<Path> jars = new Store(Path.of(args[1])).get(Lock.read(Path.of(args[0])).section("build"));
            String classPath = jars.stream().map(Path::toString).collect(Collectors.joining(":"));
            Files.writeString(Path.of(args[2]), classPath);
        } catch (BuildFailure failure) {
            System.out.println("sdkless: " + failure.getMessage());
            System.exit(1);
        }
    }
}
