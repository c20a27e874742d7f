package org.echoway.core

import java.io.File
import java.nio.ByteBuffer

/** Reads floor plans with the core's own loader. */
object PlanLoader {
    private const val FIRST_GUESS_BYTES = 1 shl 16

    /** @throws CoreException when the building is unusable; its message is `file:line: what is wrong` */
    fun load(folder: File): Plan = PlanLayout(GrowingBuffer(FIRST_GUESS_BYTES).fill { write(folder, it) }).read()

    private fun write(folder: File, buffer: ByteBuffer): Int {
        val error = arrayOfNulls<String>(1)
        val size = NativeCore.plan(folder.path, buffer, error)
        if (size < 0) throw CoreException(error[0] ?: "The building could not be read.")
        return size
    }
}
