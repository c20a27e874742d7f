package org.echoway.app.building

import java.io.InputStream

/** What was picked: files with paths relative to it, separated by slashes. */
interface BuildingFiles {
    /** Calls [visit] for each file in turn; its stream is read before the next. */
    fun forEach(visit: (path: String, open: () -> InputStream) -> Unit)
}

/** What a building may at most be. The largest known has some 400 files and less than 1 MB. */
data class ImportLimits(
    val files: Int = 5_000,
    val bytes: Long = 32L shl 20,
    val archiveBytes: Long = 32L shl 20,
    val depth: Int = 8,
)
