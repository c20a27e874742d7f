package org.echoway.app.recording

import java.io.File
import java.io.RandomAccessFile
import java.time.LocalDateTime
import java.time.format.DateTimeFormatter
import java.time.format.DateTimeParseException
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.withContext
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.isDiskFull

/** Whether the walk is being written down. */
sealed interface RecordingStatus {
    data object Off : RecordingStatus

    data class On(val name: String) : RecordingStatus

    /** It stopped, or could not begin: the disk is full, or the system said [reason]. */
    data class Failed(val diskFull: Boolean, val reason: String) : RecordingStatus
}

/**
 * A recorded walk.
 *
 * @property startedAt null for logs that were brought from elsewhere
 * @property durationS of its scans; null when they hold none
 * @property building id of the building it was made in, if the log says so
 */
data class Recording(
    val name: String,
    val startedAt: LocalDateTime?,
    val durationS: Double?,
    val bytes: Long,
    val building: String?,
) {
    val scans get() = name + Recordings.SCANS
}

/** The recorded walks in a folder. */
class Recordings(val folder: File, private val now: () -> LocalDateTime = LocalDateTime::now) {
    private val changes = MutableStateFlow(0)
    private val current = MutableStateFlow<RecordingStatus>(RecordingStatus.Off)

    /** Another number whenever [all] may have changed. */
    val revision: StateFlow<Int> = changes.asStateFlow()
    val status: StateFlow<RecordingStatus> = current.asStateFlow()

    /** Newest first; those from elsewhere last. */
    suspend fun all(): List<Recording> = withContext(Dispatchers.IO) {
        folder.listFiles().orEmpty().filter { it.name.endsWith(SCANS) }.map(::describe)
            .sortedWith(compareByDescending<Recording> { it.startedAt ?: LocalDateTime.MIN }.thenBy { it.name })
    }

    /** Begins to write a walk down; null when there is no room for it, which [status] then says. */
    fun start(building: InstalledBuilding): Recorder? {
        folder.mkdirs()
        if (folder.usableSpace < NEEDED_BYTES) {
            fail(diskFull = true, reason = "")
            return null
        }
        val name = FORMAT.format(now())
        current.value = RecordingStatus.On(name)
        return Recorder(folder, name, building.id, building.plan) {
            fail(diskFull = folder.usableSpace < NEEDED_BYTES || it.isDiskFull, it.message.orEmpty())
        }
    }

    fun stop(recorder: Recorder) {
        recorder.close()
        current.update { if (it is RecordingStatus.On) RecordingStatus.Off else it }
        changes.update { it + 1 }
    }

    /** All files of a recording, for sharing. */
    fun files(name: String): List<File> =
        listOf(SCANS, MOTION, TRACK).map { File(folder, File(name).name + it) }.filter { it.isFile }

    /** The one that is being written stays. */
    suspend fun delete(name: String) {
        if ((status.value as? RecordingStatus.On)?.name == name) return
        withContext(Dispatchers.IO) { files(name).forEach { it.delete() } }
        changes.update { it + 1 }
    }

    private fun fail(diskFull: Boolean, reason: String) {
        current.value = RecordingStatus.Failed(diskFull, reason)
    }

    private fun describe(scans: File): Recording {
        val name = scans.name.removeSuffix(SCANS)
        return Recording(name, startedAt(name), durationS(scans), files(name).sumOf { it.length() }, buildingOf(scans))
    }

    private fun startedAt(name: String) = try {
        LocalDateTime.parse(name, FORMAT)
    } catch (_: DateTimeParseException) {
        null
    }

    private fun buildingOf(scans: File): String? = scans.bufferedReader().use { reader ->
        reader.lineSequence().take(HEAD_LINES).firstOrNull { it.startsWith(BUILDING) }?.removePrefix(BUILDING)?.trim()
    }

    /** From the last whole line, without reading the rest. */
    private fun durationS(scans: File): Double? = RandomAccessFile(scans, "r").use { file ->
        file.seek(maxOf(0, file.length() - TAIL_BYTES))
        val tail = ByteArray(minOf(TAIL_BYTES, file.length()).toInt()).also(file::readFully).toString(Charsets.UTF_8)
        val whole = tail.substringBeforeLast('\n', "")
        whole.lines().asReversed().firstNotNullOfOrNull { it.substringBefore(',').toDoubleOrNull() }
    }

    companion object {
        const val SCANS = ".scans.csv"
        const val MOTION = ".motion.csv"
        const val TRACK = ".track.csv"
        private const val BUILDING = "# building "
        private const val HEAD_LINES = 10
        private const val TAIL_BYTES = 512L

        /** An hour of walking takes some 10 MB. */
        private const val NEEDED_BYTES = 20L shl 20
        private val FORMAT: DateTimeFormatter = DateTimeFormatter.ofPattern("yyyy-MM-dd_HH-mm-ss")
    }
}
