package org.echoway.app.building

import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import kotlinx.coroutines.runBlocking
import org.echoway.core.FindingKind
import org.junit.Assert.assertEquals
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith

@RunWith(AndroidJUnit4::class)
class BuildingLibraryTest {
    @get:Rule val temporary = TemporaryFolder()

    private val bundled = BundledBuildings(ApplicationProvider.getApplicationContext(), 1)

    /** With the plan of two rooms as the wearer's own, under [id]. */
    private fun library(id: String, bundled: Buildings = this.bundled): BuildingLibrary {
        val home = temporary.newFolder("imported")
        File(System.getProperty("echoway.root")!!, "maps/two-rooms").copyRecursively(File(home, id))
        return BuildingLibrary(bundled, home, temporary.newFolder("workshop"))
    }

    private fun config(id: String) = File(temporary.root, "imported/$id/building.cfg")

    /** An update may bring a plan under the name that the wearer's own has. */
    @Test fun theWearersOwnIsTheOneUntilTheyDeleteIt() = runBlocking {
        val library = library("torgersen-lab")
        assertEquals("Two rooms", library.find("torgersen-lab")?.title)
        assertEquals(listOf("Two rooms"), library.all().filter { it.id == "torgersen-lab" }.map { it.title })
        library.delete("torgersen-lab")
        assertEquals("Torgersen laboratory", library.find("torgersen-lab")?.title)
    }

    @Test fun aCheckSaysWhatIsToBeMendedWhetherOrNotItCanBeUsed() = runBlocking {
        val library = library("mine")
        assertEquals(emptyList<FindingKind>(), library.check("mine").map { it.kind })
        config("mine").appendText("\nexit nowhere 1 1\n")
        assertEquals(
            listOf("building.cfg" to FindingKind.UNKNOWN_ROOM), library.check("mine").map { it.file to it.kind },
        )
        config("mine").appendText("door\n")
        assertEquals(null, library.find("mine"))
        assertEquals(FindingKind.BAD_LINE, library.check("mine").first().kind)
        assertEquals(emptyList<FindingKind>(), library.check("another").map { it.kind })
    }

    /** It is the one that is in the list: [BuildingLibrary.find] finds no other. */
    @Test fun whereTheWearersOwnCannotBeUsedTheOneThatCameWithTheAppIsChecked() = runBlocking {
        val library = library("torgersen-lab")
        config("torgersen-lab").appendText("\ndoor\n")
        assertEquals("Torgersen laboratory", library.find("torgersen-lab")?.title)
        assertEquals(emptyList<FindingKind>(), library.check("torgersen-lab").map { it.kind })
    }

    /** They can mend theirs, and nothing of the app. */
    @Test fun whereNeitherCanBeUsedTheWearersOwnIsChecked() = runBlocking {
        val broken = temporary.newFolder("broken")
        val library = library("mine", bundled = object : Buildings by bundled {
            override suspend fun folder(id: String) = broken
        })
        config("mine").appendText("\ndoor\n")
        assertEquals(FindingKind.BAD_LINE, library.check("mine").first().kind)
        library.delete("mine")
        assertEquals(FindingKind.NO_ROOMS, library.check("mine").first().kind)
    }

    /** What the check reads anyway. */
    @Test fun aCheckLoadsNoPlanBesides() = runBlocking {
        val library = library("mine", bundled = object : Buildings by bundled {
            override suspend fun find(id: String): InstalledBuilding? = error("$id is loaded besides")
        })
        assertEquals(emptyList<FindingKind>(), library.check("torgersen-lab").map { it.kind })
    }
}
