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
    private var newestS = Double.NEGATIVE_INFINITY
    private var flushedS = Double.NEGATIVE_INFINITY

    init {
        head.forEach(::line)
        writer.flush()
    }

    /**
     * A row of what came at [timeS], in words for the time that it is given: rows are in order of time, and what was
     * held up on its way (Android tells of a step when it is sure of it) counts from when it came.
     */
    fun row(timeS: Double, text: (Double) -> String) {
        newestS = maxOf(newestS, timeS)
        line(text(newestS))
        if (newestS - flushedS < FLUSH_S) return
        writer.flush()
        flushedS = newestS
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
