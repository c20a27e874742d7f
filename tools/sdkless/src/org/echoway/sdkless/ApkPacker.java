package org.echoway.sdkless;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.TreeMap;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;

/**
 * Lays out an APK. Stored entries begin at multiples of four bytes, native libraries at pages of 16 KiB, so that
 * Android can map them as they lie.
 */
final class ApkPacker {
    private static final int WORD = 4;
    private static final int PAGE = 16384;
    private static final int LOCAL_HEADER_BYTES = 30;
    private static final int EXTRA_HEADER_BYTES = 4;
    /** Id of the extra field that Android's own tools pad with. */
    private static final short PADDING_ID = (short) 0xD935;

    private record Content(byte[] bytes, boolean stored) {}

    private final Map<String, Content> entries = new TreeMap<>();

    void resources(Path linked) throws IOException {
        try (ZipFile zip = new ZipFile(linked.toFile())) {
            for (ZipEntry entry : zip.stream().toList()) {
                boolean stored = entry.getMethod() == ZipEntry.STORED;
                entries.put(entry.getName(), new Content(zip.getInputStream(entry).readAllBytes(), stored));
            }
        }
    }

    void dex(Path file) {
        try {
            entries.put(file.getFileName().toString(), new Content(Files.readAllBytes(file), false));
        } catch (IOException e) {
            throw new BuildFailure("cannot read " + file + ": " + e.getMessage());
        }
    }

    /**
     * Native libraries, assets and Java resources of libraries, and the app's own native libraries if there are any.
     */
    void libraries(Libraries libraries, Path nativeLibraries) throws IOException {
        for (Path aar : libraries.aars()) {
            folder(aar.resolve("jni"), "lib/", true);
            folder(aar.resolve("assets"), "assets/", false);
        }
        for (Path jar : libraries.jars()) javaResources(jar);
        if (nativeLibraries != null) folder(nativeLibraries, "lib/", true);
    }

    private void folder(Path folder, String prefix, boolean stored) throws IOException {
        for (Path file : Tree.files(folder)) {
            entries.putIfAbsent(prefix + folder.relativize(file), new Content(Files.readAllBytes(file), stored));
        }
    }

    private void javaResources(Path jar) throws IOException {
        try (ZipFile zip = new ZipFile(jar.toFile())) {
            for (ZipEntry entry : zip.stream().toList()) {
                String name = entry.getName();
                boolean service = name.startsWith("META-INF/services/");
                boolean build = name.endsWith(".class") || name.startsWith("META-INF/")
                        || name.endsWith(".kotlin_builtins") || name.endsWith(".proto");
                if (entry.isDirectory() || (build && !service)) continue;
                entries.putIfAbsent(name, new Content(zip.getInputStream(entry).readAllBytes(), false));
            }
        }
    }

    void write(Path apk) throws IOException {
        Files.createDirectories(apk.getParent());
        try (CountingStream out = new CountingStream(Files.newOutputStream(apk));
                ZipOutputStream zip = new ZipOutputStream(out)) {
            for (var each : entries.entrySet()) {
                ZipEntry entry = new ZipEntry(each.getKey());
                entry.setTimeLocal(java.time.LocalDateTime.of(1981, 1, 1, 1, 1, 2));
                if (each.getValue().stored()) store(entry, each.getValue().bytes(), zip, out);
                zip.putNextEntry(entry);
                zip.write(each.getValue().bytes());
                zip.closeEntry();
            }
        }
    }

    private static void store(ZipEntry entry, byte[] bytes, ZipOutputStream zip, CountingStream out)
            throws IOException {
        CRC32 crc = new CRC32();
        crc.update(bytes);
        entry.setMethod(ZipEntry.STORED);
        entry.setSize(bytes.length);
        entry.setCrc(crc.getValue());
        zip.flush();
        int alignment = entry.getName().endsWith(".so") ? PAGE : WORD;
        long data = out.count + LOCAL_HEADER_BYTES + entry.getName().getBytes().length;
        int padding = (int) Math.floorMod(-data, (long) alignment);
        if (padding > 0 && padding < EXTRA_HEADER_BYTES) padding += alignment;
        if (padding > 0) entry.setExtra(padding(padding));
    }

    private static byte[] padding(int size) {
        return java.nio.ByteBuffer.allocate(size).order(java.nio.ByteOrder.LITTLE_ENDIAN)
                .putShort(PADDING_ID).putShort((short) (size - EXTRA_HEADER_BYTES)).array();
    }

    private static final class CountingStream extends java.io.FilterOutputStream {
        private long count;

        CountingStream(OutputStream out) {
            super(out);
        }

        @Override
        public void write(int b) throws IOException {
            out.write(b);
            count++;
        }

        @Override
        public void write(byte[] bytes, int from, int length) throws IOException {
            out.write(bytes, from, length);
            count += length;
        }
    }
}
