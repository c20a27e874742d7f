package org.echoway.app.building

import java.io.File
import java.io.IOException
import java.io.InputStream
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry
import org.apache.commons.compress.archivers.zip.ZipFile

/** The files of a zip archive. Everything about the archive is looked at before anything is unpacked. */
class ZippedBuilding(private val archive: File, private val limits: ImportLimits) : BuildingFiles {
    override fun forEach(visit: (path: String, open: () -> InputStream) -> Unit) {
        if (!hasAtMost(limits.files, DIRECTORY_ENTRY)) throw ImportException(ImportProblem.TOO_MANY_FILES)
        try {
            ZipFile.builder().setFile(archive).get().use { zip ->
                val entries = zip.entries.asSequence().take(limits.files + 1).toList()
                if (entries.size > limits.files) throw ImportException(ImportProblem.TOO_MANY_FILES)
                entries.forEach(::check)
                entries.filterNot { it.isDirectory || it.isClutter }.forEach { entry ->
                    visit(entry.name) { zip.getInputStream(entry) }
                }
            }
        } catch (e: IOException) {
            throw ImportException(ImportProblem.UNREADABLE, e.message.orEmpty(), e)
        } catch (e: IllegalArgumentException) {
            // Nonsense in an entry's own fields.
            throw ImportException(ImportProblem.UNREADABLE, e.message.orEmpty(), e)
        }
    }

    /**
     * Whether the archive has at most so many entries, before it is opened: to list a million takes more memory than a
     * phone has. What it says of their number may be a lie, but none is without its signature.
     */
    private fun hasAtMost(most: Int, signature: Int): Boolean {
        val buffer = ByteArray(BUFFER_BYTES)
        var last = 0
        var found = 0
        archive.inputStream().use { bytes ->
            var read = bytes.read(buffer)
            while (read >= 0 && found <= most) {
                for (i in 0 until read) {
                    last = (last shl 8) or (buffer[i].toInt() and 0xFF)
                    if (last == signature) found++
                }
                read = bytes.read(buffer)
            }
        }
        return found <= most
    }

    private fun check(entry: ZipArchiveEntry) {
        when {
            entry.generalPurposeBit.usesEncryption() -> throw ImportException(ImportProblem.ENCRYPTED, entry.name)
            entry.isUnixSymlink -> throw ImportException(ImportProblem.UNSAFE_NAME, entry.name)
            REPLACEMENT in entry.name || !entry.rawName.isUtf8() ->
                throw ImportException(ImportProblem.BAD_NAME, entry.name)
        }
    }

    /** What some systems add of their own. */
    private val ZipArchiveEntry.isClutter get() = name.startsWith("__MACOSX/") || name.endsWith(".DS_Store")

    private fun ByteArray.isUtf8() =
        runCatching { Charsets.UTF_8.newDecoder().decode(java.nio.ByteBuffer.wrap(this)) }.isSuccess

    private companion object {
        const val BUFFER_BYTES = 1 shl 16

        /** "PK", 1, 2: how each entry of the directory begins. */
        const val DIRECTORY_ENTRY = 0x504B0102
        const val REPLACEMENT = '\uFFFD'
    }
}
