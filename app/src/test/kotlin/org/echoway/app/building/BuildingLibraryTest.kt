package org.echoway.app.building

import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith

@RunWith(AndroidJUnit4::class)
class BuildingLibraryTest {
    @get:Rule val temporary = TemporaryFolder()

    /** An update may bring a plan under the name that the wearer's own has. */
    @Test fun theWearersOwnIsTheOneUntilTheyDeleteIt() = runBlocking {
        val home = temporary.newFolder("imported")
        File(System.getProperty("echoway.root")!!, "maps/two-rooms").copyRecursively(File(home, "torgersen-lab"))
        val library = BuildingLibrary(BundledBuildings(ApplicationProvider.getApplicationContext(), 1), home, temporary.newFolder("workshop"))
        assertEquals("Two rooms", library.find("torgersen-lab")?.title)
        assertEquals(listOf("Two rooms"), library.all().filter { it.id == "torgersen-lab" }.map { it.title })
        library.delete("torgersen-lab")
        assertEquals("Torgersen laboratory", library.find("torgersen-lab")?.title)
    }
}
