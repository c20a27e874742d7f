package org.echoway.sdkless;

import com.android.apksig.ApkVerifier;
import com.android.apksig.apk.ApkFormatException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.util.List;

/** The debug APK: dexed, packed, aligned, signed, and verified before it is called done. */
final class Apk {
    private static final String NAME = "echoway-debug.apk";
    private final Workspace workspace;

    Apk(Workspace workspace) {
        this.workspace = workspace;
    }

    /** {@code nativeLibraries}: a folder with one folder of libraries for each ABI, or null. */
    void build(Path nativeLibraries) throws IOException {
        Libraries libraries = Libraries.of(workspace, "app");
        Resources resources = new Resources(workspace, "apk", libraries.aars());
        resources.build();
        Compilation compilation = new Compilation(workspace, "apk");
        compilation.main(resources);
        List<Path> dex = new Dex(workspace).build(libraries.jars(), resources, compilation);

        Path unsigned = workspace.build.resolve("apk/unsigned.apk");
        ApkPacker packer = new ApkPacker();
        packer.resources(resources.linked());
        dex.forEach(packer::dex);
        packer.libraries(libraries, nativeLibraries);
        packer.write(unsigned);

        Path signed = workspace.root.resolve("build").resolve(NAME);
        sign(unsigned, signed);
        report(signed, dex, nativeLibraries);
    }

    private void sign(Path unsigned, Path signed) throws IOException {
        try {
            new Signer(workspace.build.resolve("debug.p12")).sign(unsigned, signed, Resources.MIN_SDK);
            ApkVerifier.Result result = new ApkVerifier.Builder(signed.toFile()).build().verify();
            if (!result.isVerified()) {
                throw new BuildFailure("the APK's signature does not verify: " + result.getErrors());
            }
        } catch (GeneralSecurityException | ApkFormatException e) {
            throw new BuildFailure("cannot sign the APK: " + e);
        }
    }

    private void report(Path apk, List<Path> dex, Path nativeLibraries) throws IOException {
        String badging = Exec.run("reading the APK",
                List.of(Resources.aapt2(workspace).toString(), "dump", "badging", apk.toString()));
        badging.lines()
                .filter(line -> line.startsWith("package:") || line.startsWith("launchable-activity:"))
                .forEach(System.out::println);
        int methods = 0;
        for (Path file : dex) methods += methodReferences(file);
        System.out.printf("%s: %.2f MB, %d method references in %d dex files, signature verified%n",
                workspace.root.relativize(apk), Files.size(apk) / 1e6, methods, dex.size());
        if (nativeLibraries == null) {
            System.out.println(
                    "No NDK was found: the APK holds no native library and cannot locate anyone. "
                            + "Gradle with the NDK builds the whole app.");
        }
        System.out.println(
                "usb-serial-for-android is not in this APK but a stand-in that knows no device: "
                        + "belts are replayed or simulated only.");
    }

    /** The count of method ids in a dex file's header. */
    private static int methodReferences(Path dex) throws IOException {
        final int methodIdsSize = 0x58;
        return ByteBuffer.wrap(Files.readAllBytes(dex)).order(ByteOrder.LITTLE_ENDIAN).getInt(methodIdsSize);
    }
}
