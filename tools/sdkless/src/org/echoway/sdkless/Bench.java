package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Times the way from the belt's bytes to an estimate in Kotlin, on this machine's JVM. */
final class Bench {
    private final Workspace workspace;

    Bench(Workspace workspace) {
        this.workspace = workspace;
    }

    void run(Path nativeLibraries) throws IOException {
        Libraries libraries = Libraries.of(workspace, "app");
        Resources resources = new Resources(workspace, "apk", libraries.aars());
        resources.build();
        Compilation compilation = new Compilation(workspace, "apk");
        compilation.main(resources);
        Path classes = workspace.build.resolve("classes/bench");
        List<Path> classPath = new ArrayList<>(List.of(compilation.app, compilation.core));
        classPath.addAll(libraries.jars());
        new Kotlin(workspace).compile(
                "bench", List.of(workspace.root.resolve("tools/sdkless/bench")), classPath, List.of(), classes);
        classPath.add(0, classes);
        int status = Exec.status(List.of(Exec.JAVA, "-Djava.library.path=" + nativeLibraries, "-cp",
                Exec.join(classPath), "org.echoway.bench.FiringBenchKt", workspace.root.toString()));
        if (status != 0) throw new BuildFailure("the benchmark failed");
    }
}
