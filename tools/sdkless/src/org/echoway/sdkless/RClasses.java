package org.echoway.sdkless;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Writes R classes: all symbols for the app's package, and for each library those that its own R.txt lists. */
final class RClasses {
    private static final Pattern SYMBOL = Pattern.compile("(int(?:\\[])?) (\\w+) (\\w+) (.+)");
    private static final Pattern PACKAGE = Pattern.compile("package=\"([^\"]+)\"");

    private record Symbol(String kind, String name, String value, boolean array) {}

    private final Map<String, Symbol> linked;
    private final List<Path> aars;

    RClasses(Path symbols, List<Path> aars) throws IOException {
        linked = read(symbols);
        this.aars = aars;
    }

    void write(Path jar) throws IOException {
        Map<String, Map<String, Symbol>> packages = new TreeMap<>();
        packages.put(Layout.PACKAGE, linked);
        for (Path aar : aars) {
            if (!Files.exists(aar.resolve("R.txt"))) continue;
            Map<String, Symbol> own = packages.computeIfAbsent(packageOf(aar), name -> new LinkedHashMap<>());
            for (String key : read(aar.resolve("R.txt")).keySet()) {
                if (linked.containsKey(key)) own.put(key, linked.get(key));
            }
        }
        try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
            for (var each : packages.entrySet()) {
                writePackage(out, each.getKey().replace('.', '/') + "/R", each.getValue());
            }
        }
    }

    private static String packageOf(Path aar) throws IOException {
        Matcher matcher = PACKAGE.matcher(Files.readString(aar.resolve("AndroidManifest.xml")));
        if (!matcher.find()) throw new BuildFailure(aar + "/AndroidManifest.xml names no package");
        return matcher.group(1);
    }

    private static Map<String, Symbol> read(Path symbols) throws IOException {
        Map<String, Symbol> found = new LinkedHashMap<>();
        for (String line : Files.readAllLines(symbols)) {
            Matcher m = SYMBOL.matcher(line.strip());
            if (m.matches()) {
                found.put(m.group(2) + " " + m.group(3),
                        new Symbol(m.group(2), m.group(3), m.group(4), m.group(1).endsWith("]")));
            }
        }
        return found;
    }

    private static void writePackage(ZipOutputStream out, String outer, Map<String, Symbol> symbols)
            throws IOException {
        Map<String, Map<String, Symbol>> kinds = new TreeMap<>();
        symbols.forEach(
                (key, symbol) -> kinds.computeIfAbsent(symbol.kind(), kind -> new LinkedHashMap<>()).put(key, symbol));
        int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER;
        ClassWriter top = new ClassWriter(0);
        top.visit(Opcodes.V11, access, outer, null, "java/lang/Object", null);
        for (var kind : kinds.entrySet()) {
            String inner = outer + "$" + kind.getKey();
            ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
            writer.visit(Opcodes.V11, access, inner, null, "java/lang/Object", null);
            for (ClassWriter each : List.of(top, writer)) {
                each.visitInnerClass(
                        inner, outer, kind.getKey(), Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_STATIC);
            }
            writeFields(writer, inner, kind.getValue());
            put(out, inner, writer);
        }
        put(out, outer, top);
    }

    private static void writeFields(ClassWriter writer, String owner, Map<String, Symbol> symbols) {
        int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC | Opcodes.ACC_FINAL;
        MethodVisitor arrays = writer.visitMethod(Opcodes.ACC_STATIC, "<clinit>", "()V", null, null);
        arrays.visitCode();
        for (Symbol symbol : symbols.values()) {
            if (!symbol.array()) {
                writer.visitField(access, symbol.name(), "I", null, Integer.decode(symbol.value())).visitEnd();
                continue;
            }
            writer.visitField(access, symbol.name(), "[I", null, null).visitEnd();
            String[] values = symbol.value().replaceAll("[{}\\s]", "").split(",");
            int count = values[0].isEmpty() ? 0 : values.length;
            arrays.visitLdcInsn(count);
            arrays.visitIntInsn(Opcodes.NEWARRAY, Opcodes.T_INT);
            for (int i = 0; i < count; i++) {
                arrays.visitInsn(Opcodes.DUP);
                arrays.visitLdcInsn(i);
                arrays.visitLdcInsn(Integer.decode(values[i]));
                arrays.visitInsn(Opcodes.IASTORE);
            }
            arrays.visitFieldInsn(Opcodes.PUTSTATIC, owner, symbol.name(), "[I");
        }
        arrays.visitInsn(Opcodes.RETURN);
        arrays.visitMaxs(0, 0);
        arrays.visitEnd();
    }

    private static void put(ZipOutputStream out, String name, ClassWriter writer) throws IOException {
        out.putNextEntry(new ZipEntry(name + ".class"));
        out.write(writer.toByteArray());
    }
}
