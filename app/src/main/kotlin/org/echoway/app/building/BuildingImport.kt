package org.echoway.app.building

import java.io.File
import java.io.IOException
import java.io.InputStream
import org.echoway.app.copyAtMost
import org.echoway.app.isDiskFull
import org.echoway.core.BuildingCheck
import org.echoway.core.Finding

/** A building that was taken in; [findings] are what the core would have mended, and did not stop it. */
data class Imported(val id: String, val findings: List<Finding>)

/** Raised with what the core found when it cannot use a building. */
class UnusableBuilding(val findings: List<Finding>) : Exception(findings.firstOrNull()?.problem)

/**
 * Takes buildings in from what the wearer picked. Files come from anywhere: their names are not trusted, neither is
 * what they say of their own size. A building is laid out in [workshop], looked through by the core, and moved below
 * [home] as a whole; whatever goes wrong, nothing is left behind. Not for the main thread.
 *
 * [isTaken] tells ids that are in use elsewhere.
 *
 * REQUIRES: [workshop] and [home] lie in the same file system, and nobody else uses [workshop].
 */
class BuildingImport(
    private val home: File,
    private val workshop: File,
    private val limits: ImportLimits = ImportLimits(),
    private val isTaken: (String) -> Boolean = { false },
) {
    /** @throws ImportException [UnusableBuilding] when what was picked cannot be kept */
    fun zip(name: String, open: () -> InputStream): Imported = cleanly {
        val archive = File(workshop, "archive")
        val copied = open().use { copy(it, archive, limits.archiveBytes) }
        if (copied == 0L) throw ImportException(ImportProblem.UNREADABLE)
        take(name, ZippedBuilding(archive, limits))
    }

    /** @throws ImportException [UnusableBuilding] when what was picked cannot be kept */
    fun folder(name: String, files: BuildingFiles): Imported = cleanly { take(name, files) }

    private fun <T> cleanly(work: () -> T): T {
        workshop.deleteRecursively()
        try {
            if (!workshop.mkdirs()) throw ImportException(ImportProblem.DISK_FULL)
            return work()
        } catch (e: IOException) {
            throw ImportException(
                if (e.isDiskFull) ImportProblem.DISK_FULL else ImportProblem.UNREADABLE, e.message.orEmpty(), e,
            )
        } finally {
            workshop.deleteRecursively()
        }
    }

    private fun take(name: String, files: BuildingFiles): Imported {
        val unpacked = File(workshop, "unpacked").also { it.mkdirs() }
        unpack(files, unpacked)
        val building = theBuildingIn(unpacked)
        val check = BuildingCheck.of(building)
        val findings = check.findings.map { it.copy(file = File(it.file).name) }
        if (!check.usable) throw UnusableBuilding(findings)
        val id = freeId(name)
        home.mkdirs()
        if (!building.renameTo(File(home, id))) throw ImportException(ImportProblem.DISK_FULL)
        return Imported(id, findings)
    }

    private fun unpack(files: BuildingFiles, into: File) {
        val names = mutableSetOf<String>()
        var left = limits.bytes
        files.forEach { path, open ->
            val parts = safeParts(path)
            if (!names.add(path)) throw ImportException(ImportProblem.DUPLICATE_NAME, path)
            if (names.size > limits.files) throw ImportException(ImportProblem.TOO_MANY_FILES)
            val target = parts.fold(into, ::File)
            target.parentFile?.mkdirs()
            left -= open().use { copy(it, target, left) }
        }
    }

    /** What an entry says of its own size is no limit: a bomb lies. */
    private fun copy(from: InputStream, to: File, most: Long): Long =
        from.copyAtMost(most, to) ?: throw ImportException(ImportProblem.TOO_LARGE)

    private fun safeParts(path: String): List<String> {
        val parts = path.split('/')
        val unsafe = parts.any {
            it.isEmpty() || it == "." || it == ".." || '\\' in it || ':' in it || it.any(Char::isISOControl)
        }
        if (unsafe || parts.size > limits.depth + 1) throw ImportException(ImportProblem.UNSAFE_NAME, path)
        if (parts.any { it.toByteArray().size > MAX_NAME_BYTES }) {
            throw ImportException(ImportProblem.BAD_NAME, path.take(MAX_NAME_BYTES))
        }
        return parts
    }

    /** Archives often hold the folder and not only its files. */
    private fun theBuildingIn(folder: File): File {
        val found = folder.walkTopDown().filter { it.name == CONFIG && it.isFile }.map { it.parentFile!! }.toList()
        return when (found.size) {
            0 -> throw ImportException(ImportProblem.NO_BUILDING)
            1 -> found.single()
            else -> throw ImportException(ImportProblem.SEVERAL_BUILDINGS)
        }
    }

    private fun freeId(name: String): String {
        val base = name.lowercase()
            .substringBeforeLast(".zip")
            .replace(Regex("[^\\p{L}\\p{N}]+"), "-")
            .trim('-')
            .take(MAX_ID)
            .ifEmpty { "building" }
        return generateSequence(1) { it + 1 }
            .map { if (it == 1) base else "$base-$it" }
            .first { !isTaken(it) && !File(home, it).exists() }
    }

    private companion object {
        const val CONFIG = "building.cfg"
        const val MAX_NAME_BYTES = 200
        const val MAX_ID = 60
    }
}
