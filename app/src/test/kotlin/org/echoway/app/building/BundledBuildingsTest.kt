package org.echoway.app.building

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import kotlinx.coroutines.awaitAll
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNotNull
import org.junit.Assert.assertNull
import org.junit.Test
import org.junit.runner.RunWith

@RunWith(AndroidJUnit4::class)
class BundledBuildingsTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()

    /** After an update the screen asks, and the service that a belt's plugging-in has started. */
    @Test fun askedForFromSeveralSidesAtOnceTheyAreAllThere() = runBlocking(Dispatchers.IO) {
        for (version in 1L..5L) {
            val buildings = BundledBuildings(context, version)
            val found = List(8) { async { buildings.all().map { it.id } } }.awaitAll()
            assertEquals(List(8) { BundledBuildings(context, version).all().map { it.id } }, found)
            assertNotNull(buildings.find("torgersen-lab"))
        }
    }

    @Test fun anUpdateTakesAwayThePlansOfTheLastAndNoneThatTheWearerBrought() = runBlocking {
        val own = File(context.filesDir, "buildings/imported/bundled-1/building.cfg").apply { parentFile!!.mkdirs() }
        own.writeText("name \"Mine\"\n")
        BundledBuildings(context, 1).all()
        assertNotNull(BundledBuildings(context, 2).find("torgersen-lab"))
        assertEquals(setOf("bundled-2", "imported"), File(context.filesDir, "buildings").list()!!.toSet())
        assertEquals("name \"Mine\"\n", own.readText())
    }

    @Test fun onAPhoneThatIsFullThereAreNoneUntilItHasRoom() = runBlocking {
        val folder = File(context.filesDir, "buildings")
        folder.writeText("where the folder should be")
        val buildings = BundledBuildings(context, 1)
        assertEquals(emptyList<InstalledBuilding>(), buildings.all())
        assertNull(buildings.find("torgersen-lab"))
        folder.delete()
        assertNotNull(buildings.find("torgersen-lab"))
    }
}
