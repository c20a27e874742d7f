package org.echoway.app.building

import android.content.Context
import java.io.File
import java.io.IOException
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import org.echoway.app.entry
import org.echoway.core.CoreException
import org.echoway.core.Plan
import org.echoway.core.PlanLoader

/** A floor plan on this phone; [imported] ones can be deleted. */
data class InstalledBuilding(val id: String, val folder: File, val plan: Plan, val imported: Boolean = false) {
    /** What a wearer calls it. */
    val title get() = plan.name.ifEmpty { id }
}

/** The floor plans that can be walked in. */
interface Buildings {
    /** All that the core can use, in order of their titles. */
    suspend fun all(): List<InstalledBuilding>

    /** Null when there is none of that id, or it is unusable. */
    suspend fun find(id: String): InstalledBuilding?

    /** Where the plan of that id lies, whether or not it can be used; null when there is none. */
    suspend fun folder(id: String): File?
}

/**
 * Plans that came with the app, laid out as files because the core reads folders.
 *
 * @param installed another number after every update: then they are laid out anew, and those of the last one taken away
 */
class BundledBuildings(private val context: Context, installed: Long) : Buildings {
    private val folder = File(context.filesDir, "buildings/$BUNDLED$installed")
    private val installing = Mutex()

    override suspend fun all(): List<InstalledBuilding> = withContext(Dispatchers.IO) {
        install()
        folder.listFiles().orEmpty().mapNotNull(::load).sortedBy { it.title }
    }

    override suspend fun find(id: String): InstalledBuilding? = withContext(Dispatchers.IO) { folder(id)?.let(::load) }

    override suspend fun folder(id: String): File? = withContext(Dispatchers.IO) {
        install()
        folder.entry(id)
    }

    private fun load(building: File): InstalledBuilding? = try {
        InstalledBuilding(building.name, building, PlanLoader.load(building))
    } catch (_: CoreException) {
        null
    }

    /**
     * One at a time: a belt that is plugged in asks while the screen does. On a phone that is full there are none until
     * it has room.
     */
    private suspend fun install() = installing.withLock {
        val partial = File(folder.parentFile, "partial")
        try {
            if (!folder.isDirectory) {
                dropEarlier()
                layOut(partial)
            }
        } catch (_: IOException) {
            // No room: the next who asks tries again.
        } finally {
            partial.deleteRecursively()
        }
    }

    /** First, for they may be what fills the phone. */
    private fun dropEarlier() = folder.parentFile?.listFiles().orEmpty()
        .filter { it.name.startsWith(BUNDLED) }
        .forEach { it.deleteRecursively() }

    private fun layOut(partial: File) {
        partial.deleteRecursively()
        // Android lists folders here; the host's tests list whole paths.
        val folders = context.assets.list("").orEmpty().map { it.substringBefore('/') }.distinct()
        for (id in folders) {
            val files = context.assets.list(id).orEmpty()
            if (CONFIG in files) files.forEach { copy("$id/$it", File(partial, "$id/$it")) }
        }
        if (!partial.renameTo(folder)) throw IOException("cannot lay out the floor plans in $folder")
    }

    private fun copy(asset: String, target: File) {
        target.parentFile?.mkdirs()
        // A folder inside a building's folder is none of its files.
        val input = try {
            context.assets.open(asset)
        } catch (_: IOException) {
            return
        }
        input.use { from -> target.outputStream().use { from.copyTo(it) } }
    }

    private companion object {
        const val CONFIG = "building.cfg"
        const val BUNDLED = "bundled-"
    }
}
