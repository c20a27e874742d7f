package org.echoway.app.recording

import java.io.Closeable
import java.io.File
import java.io.FileOutputStream
import java.io.OutputStreamWriter

/**
 * A log of the contract that grows. Whole lines reach the file once a second, so that a crash costs at most the last
 * second and one torn line, which readers forgive.
 */
internal class LogFile(file: File, head: List<String>) : Closeable {
    private val writer = OutputStreamWriter(FileOutputStream(file), Charsets.UTF_8).buffered()
    private var flushedS = Double.NEGATIVE_INFINITY

    init {
        head.forEach(::line)
        writer.flush()
    }

    fun row(timeS: Double, text: String) {
        line(text)
        if (timeS - flushedS < FLUSH_S && timeS >= flushedS) return
        writer.flush()
        flushedS = timeS
    }

    private fun line(text: String) {
        writer.write(text)
        writer.write("\n")
    }

    override fun close() = writer.close()

    private companion object {
        const val FLUSH_S = 1.0
    }
}
