package org.echoway.sdkless;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Enumeration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * What stands for android.jar: the platform that Robolectric runs on, with the traces of its instrumentation removed,
 * constants made final again and bodies dropped. It lets hidden APIs through unnoticed; Android's own build does not.
 */
final class Platform {
    private static final List<String> PACKAGES =
            List.of("android/", "dalvik/", "org/json/", "org/xmlpull/", "org/apache/http/");
    private static final String ROBOLECTRIC = "org/robolectric/";

    private Platform() {}

    static Path instrumented(Workspace workspace) throws IOException {
        return workspace.file("platform", "org.robolectric:android-all-instrumented");
    }

    static Path stub(Workspace workspace) throws IOException {
        Path instrumented = instrumented(workspace);
        Path stub = workspace.derived("platform", instrumented).resolve("android-stub.jar");
        new Stamp().words("platform stub 1").paths(List.of(instrumented))
                .guard("platform stub", stub, () -> write(instrumented, stub));
        return stub;
    }

    private static void write(Path instrumented, Path stub) throws IOException {
        Files.createDirectories(stub.getParent());
        try (ZipFile in = new ZipFile(instrumented.toFile());
             OutputStream file = Files.newOutputStream(stub);
             ZipOutputStream out = new ZipOutputStream(file)) {
            Deque<String> queue = new ArrayDeque<>();
            for (Enumeration<? extends ZipEntry> all = in.entries(); all.hasMoreElements(); ) {
                String name = all.nextElement().getName();
                if (name.endsWith(".class") && PACKAGES.stream().anyMatch(name::startsWith)) {
                    queue.add(name.substring(0, name.length() - 6));
                }
            }
            Set<String> done = new HashSet<>();
            while (!queue.isEmpty()) {
                String name = queue.poll();
                ZipEntry entry = done.add(name) ? in.getEntry(name + ".class") : null;
                if (entry == null || name.matches(".*\\$\\d+$")) continue;
                byte[] stripped = strip(in.getInputStream(entry), queue);
                if (stripped == null) continue;
                out.putNextEntry(new ZipEntry(name + ".class"));
                out.write(stripped);
            }
        }
    }

    /** Null for synthetic classes. Supertypes outside the platform's packages are added to the queue. */
    private static byte[] strip(InputStream in, Deque<String> supertypes) throws IOException {
        ClassReader reader = new ClassReader(in.readAllBytes());
        if ((reader.getAccess() & Opcodes.ACC_SYNTHETIC) != 0) return null;
        ClassWriter writer = new ClassWriter(0);
        reader.accept(new Stripper(writer, supertypes), ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
        return writer.toByteArray();
    }

    private static final class Stripper extends ClassVisitor {
        private static final int VISIBLE = Opcodes.ACC_PUBLIC | Opcodes.ACC_PROTECTED;
        private final Deque<String> supertypes;

        Stripper(ClassVisitor next, Deque<String> supertypes) {
            super(Opcodes.ASM9, next);
            this.supertypes = supertypes;
        }

        @Override
        public void visit(
                int version, int access, String name, String signature, String superName, String[] interfaces) {
            List<String> kept =
                    java.util.Arrays.stream(interfaces).filter(each -> !each.startsWith(ROBOLECTRIC)).toList();
            supertypes.addAll(kept);
            if (superName != null) supertypes.add(superName);
            String clean = signature == null ? null : signature.replaceAll("Lorg/robolectric/[^;]*;", "");
            super.visit(Math.min(version & 0xffff, Opcodes.V17), access, name, clean, superName,
                    kept.toArray(new String[0]));
        }

        @Override
        public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
            if ((access & VISIBLE) == 0 || name.equals("__robo_data__")) return null;
            // Instrumentation takes `final` off constants; without it they are none to a compiler.
            return super.visitField(
                    value != null ? access | Opcodes.ACC_FINAL : access, name, descriptor, signature, value);
        }

        @Override
        public MethodVisitor visitMethod(
                int access, String name, String descriptor, String signature, String[] exceptions) {
            boolean instrumentation = name.contains("$$robo") || descriptor.contains(ROBOLECTRIC);
            if ((access & VISIBLE) == 0 || instrumentation || name.equals("<clinit>")) return null;
            return new BodyDropper(super.visitMethod(access, name, descriptor, signature, exceptions), descriptor);
        }

        @Override
        public AnnotationVisitor visitAnnotation(String descriptor, boolean visible) {
            return descriptor.startsWith("Lcom/google/errorprone/") ? null : super.visitAnnotation(descriptor, visible);
        }
    }

    /** Keeps annotations and defaults; the code becomes `throw null`. */
    private static final class BodyDropper extends MethodVisitor {
        private final int slots;

        BodyDropper(MethodVisitor next, String descriptor) {
            super(Opcodes.ASM9, next);
            slots = 1 + (Type.getArgumentsAndReturnSizes(descriptor) >> 2);
        }

        @Override
        public void visitCode() {
            super.visitCode();
            super.visitInsn(Opcodes.ACONST_NULL);
            super.visitInsn(Opcodes.ATHROW);
            super.visitMaxs(1, slots);
            mv = null;
        }
    }
}
