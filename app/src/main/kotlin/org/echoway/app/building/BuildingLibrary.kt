package org.echoway.app.building

import android.content.Context
import java.io.File
import java.io.InputStream
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import org.echoway.app.entry
import org.echoway.core.BuildingCheck
import org.echoway.core.CoreException
import org.echoway.core.Finding
import org.echoway.core.PlanLoader

/**
 * The floor plans that came with the app, and those that the wearer brought, each in a folder of its own below [home].
 * Where an update brings one of the same id as the wearer has, theirs is the one until they delete it.
 */
class BuildingLibrary(private val bundled: Buildings, private val home: File, private val workshop: File) : Buildings {
    private val changes = MutableStateFlow(0)
    private val importing = Mutex()

    /** Another number whenever [all] may have changed. */
    val revision: StateFlow<Int> = changes.asStateFlow()

    override suspend fun all(): List<InstalledBuilding> {
        val own = withContext(Dispatchers.IO) { home.listFiles().orEmpty().mapNotNull(::load) }
        return (own + bundled.all()).distinctBy { it.id }.sortedBy { it.title }
    }

    override suspend fun find(id: String): InstalledBuilding? =
        withContext(Dispatchers.IO) { own(id)?.let(::load) } ?: bundled.find(id)

    /** Of the wearer's own, where there is one. */
    override suspend fun folder(id: String): File? = withContext(Dispatchers.IO) { own(id) } ?: bundled.folder(id)

    /**
     * What the core would mend in the building that [find] finds, or why there is none to be found: of the wearer's
     * own, where they have one. Empty for one that is not there.
     */
    suspend fun check(id: String): List<Finding> = withContext(Dispatchers.IO) {
        val own = own(id)?.let(BuildingCheck::of)
        val used = own?.takeIf { it.usable }
            ?: bundled.folder(id)?.let(BuildingCheck::of)?.takeIf { it.usable || own == null }
            ?: own
        used?.findings.orEmpty().map { it.copy(file = File(it.file).name) }
    }

    /** @throws ImportException [UnusableBuilding] */
    suspend fun importZip(name: String, open: () -> InputStream): Imported = take { it.zip(name, open) }

    /** @throws ImportException [UnusableBuilding] */
    suspend fun importFolder(name: String, files: BuildingFiles): Imported = take { it.folder(name, files) }

    /** Deletes an imported building; the ones that came with the app stay. */
    suspend fun delete(id: String) {
        withContext(Dispatchers.IO) { own(id)?.deleteRecursively() }
        changes.update { it + 1 }
    }

    private suspend fun take(work: (BuildingImport) -> Imported): Imported = importing.withLock {
        val taken = bundled.all().map { it.id }.toSet()
        val imported = withContext(Dispatchers.IO) { work(BuildingImport(home, workshop, isTaken = { it in taken })) }
        changes.update { it + 1 }
        imported
    }

    private fun own(id: String): File? = home.entry(id)

    private fun load(folder: File): InstalledBuilding? = try {
        InstalledBuilding(folder.name, folder, PlanLoader.load(folder), imported = true)
    } catch (_: CoreException) {
        null
    }

    companion object {
        fun on(context: Context, bundled: Buildings): BuildingLibrary {
            val root = File(context.filesDir, "buildings")
            return BuildingLibrary(bundled, File(root, "imported"), File(root, "workshop"))
        }
    }
}
