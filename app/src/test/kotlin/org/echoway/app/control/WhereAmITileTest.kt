package org.echoway.app.control

import android.app.PendingIntent
import android.service.quicksettings.Tile
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.lang.reflect.Proxy
import java.util.concurrent.TimeUnit
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import org.echoway.app.MainActivity
import org.echoway.app.service.TestApp
import org.echoway.core.Start
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowLooper
import org.robolectric.util.ReflectionHelpers

@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class)
class WhereAmITileTest {
    private val app = ApplicationProvider.getApplicationContext<TestApp>()
    private val container get() = app.container
    private val tile = Robolectric.buildService(WhereAmITile::class.java).create().get()

    private fun settle(millis: Long = 2_000) = repeat(20) {
        ShadowLooper.idleMainLooper(millis / 20, TimeUnit.MILLISECONDS)
        Thread.sleep(2)
    }

    @Test fun withoutGuidanceItSaysSoAndOpensTheApp() {
        val opened = quickSettings()
        tile.onStartListening()
        assertEquals(Tile.STATE_INACTIVE, tile.qsTile.state)
        assertEquals("Where am I?", tile.qsTile.label)
        tile.onClick()
        settle()
        assertEquals(listOf("Guidance is off."), container.voice.words)
        assertEquals(
            listOf(MainActivity::class.java.name), opened.map { shadowOf(it).savedIntent.component?.className },
        )
    }

    /** The system's side of the tile, which the shadow leaves out; what it was asked to open. */
    private fun quickSettings(): List<PendingIntent> {
        val opened = mutableListOf<PendingIntent>()
        val service = Class.forName("android.service.quicksettings.IQSService")
        val proxy = Proxy.newProxyInstance(service.classLoader, arrayOf(service)) { _, method, arguments ->
            if (method.name == "startActivity") opened += arguments.filterIsInstance<PendingIntent>()
            null
        }
        ReflectionHelpers.setField(tile, "mService", proxy)
        return opened
    }

    @Test fun whileGuidanceRunsItAnswers() {
        val scope = CoroutineScope(Dispatchers.Main)
        val laboratory = runBlocking { container.buildings.find("torgersen-lab")!! }
        scope.launch {
            container.guide.run(container.navigator.state, container.navigator.events, container.settings.settings)
        }
        scope.launch { container.navigator.run(laboratory, Start(), container.belt, container.motion) }
        settle()
        tile.onStartListening()
        assertEquals(Tile.STATE_ACTIVE, tile.qsTile.state)
        tile.onClick()
        settle()
        assertTrue("${container.voice.words}", "Belt disconnected." in container.voice.words)
        assertEquals(null, shadowOf(app).nextStartedActivity)
        scope.cancel()
    }
}
