package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The asset folders of the app, laid over each other. */
final class Assets {
    private final Workspace workspace;

    Assets(Workspace workspace) {
        this.workspace = workspace;
    }

    Path merge() throws IOException {
        Path merged = workspace.build.resolve("assets");
        Stamp stamp = new Stamp();
        for (String folder : Layout.APP.assets()) stamp.file(source(folder));
        stamp.guard("assets", merged, () -> {
            Tree.delete(merged);
            Files.createDirectories(merged);
            for (String folder : Layout.APP.assets()) {
                for (Path file : Tree.files(source(folder))) {
                    Path target = merged.resolve(source(folder).relativize(file).toString());
                    Files.createDirectories(target.getParent());
                    Files.copy(file, target);
                }
            }
        });
        return merged;
    }

    private Path source(String folder) {
        return workspace.root.resolve(Layout.APP.folder()).resolve(folder).normalize();
    }
}
