package org.echoway.app.service

import android.app.Notification
import android.app.NotificationManager
import android.view.KeyEvent
import android.view.KeyEvent.KEYCODE_VOLUME_DOWN
import android.view.KeyEvent.KEYCODE_VOLUME_UP
import android.view.View
import android.widget.FrameLayout
import androidx.test.core.app.ActivityScenario
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.util.concurrent.TimeUnit
import org.echoway.app.MainActivity
import org.echoway.app.R
import org.echoway.app.control.WhereAmITile
import org.echoway.app.control.openSessions
import org.echoway.app.control.press
import org.echoway.app.engine.NavigationState
import org.echoway.app.guide.Ask
import org.echoway.core.Language
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowLooper

/**
 * Every way of asking, and the exact words that are heard then: the table of docs/voice-and-touch.md. Guidance is on
 * and the belt not plugged in, so that the answers do not depend on a place.
 */
@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class)
class AskingTest {
    private val app = ApplicationProvider.getApplicationContext<TestApp>()
    private val container get() = app.container
    private val service = Robolectric.buildService(NavigationService::class.java).create()

    private fun settle(millis: Long) = repeat(20) {
        ShadowLooper.idleMainLooper(millis / 20, TimeUnit.MILLISECONDS)
        Thread.sleep(1)
    }

    @Before fun start() {
        service.get().onStartCommand(NavigationService.intent(app, NavigationService.ACTION_START), 0, 1)
        var patience = 500
        while (container.navigator.state.value !is NavigationState.Running && patience-- > 0) settle(20)
        settle(20_000)
        assertEquals(listOf("Waiting for the belt."), container.voice.words)
    }

    @After fun stop() {
        service.destroy()
    }

    /** What is heard after [asking]. */
    private fun heard(asking: () -> Unit): List<String> {
        container.voice.heard.clear()
        asking()
        settle(12_000)
        return container.voice.words.toList()
    }

    private fun assertAnswers(whereAmI: () -> Unit, repeat: () -> Unit, mute: () -> Unit, wayOut: () -> Unit) {
        assertEquals("where am I", listOf("Belt disconnected."), heard(whereAmI))
        assertEquals("mute", listOf("Muted. Danger is still spoken."), heard(mute))
        assertEquals("repeat", listOf("Muted. Danger is still spoken."), heard(repeat))
        assertEquals("speak again", listOf("Speaking again."), heard(mute))
        assertEquals("way out", listOf("Belt disconnected."), heard(wayOut))
    }

    private fun notification(): Notification =
        shadowOf(app.getSystemService(NotificationManager::class.java)).getNotification(NavigationNotification.ID)

    /** Android starts the service with what the button holds. */
    private fun deliver(press: () -> Unit) {
        while (shadowOf(app).nextStartedService != null) Unit
        press()
        service.get().onStartCommand(shadowOf(app).nextStartedService, 0, 2)
    }

    private fun action(title: String) =
        deliver { notification().actions.first { it.title.toString() == title }.actionIntent.send() }

    private fun unfolded(id: Int) = deliver {
        @Suppress("DEPRECATION") // for who builds it; who shows it reads it there
        notification().bigContentView.apply(app, FrameLayout(app)).findViewById<View>(id).performClick()
    }

    @Test fun byNotification() {
        assertAnswers(
            whereAmI = { action("Where am I?") },
            repeat = { unfolded(R.id.repeat) },
            mute = { unfolded(R.id.mute) },
            wayOut = { action("Way out") },
        )
        assertEquals(listOf("No way back yet."), heard { unfolded(R.id.way_back) })
        assertEquals(listOf("Guidance is off."), heard { action("Stop") })
    }

    @Test fun byTheKeysOfAHeadset() {
        val guidance = openSessions().single()
        fun press(vararg keys: Int) = keys.forEach {
            guidance.press(it)
            settle(200)
        }
        assertAnswers(
            whereAmI = { press(KeyEvent.KEYCODE_HEADSETHOOK) },
            repeat = { press(KeyEvent.KEYCODE_HEADSETHOOK, KeyEvent.KEYCODE_HEADSETHOOK) },
            mute = { press(KeyEvent.KEYCODE_MEDIA_STOP) },
            wayOut = {
                press(KeyEvent.KEYCODE_HEADSETHOOK, KeyEvent.KEYCODE_HEADSETHOOK, KeyEvent.KEYCODE_HEADSETHOOK)
            },
        )
        assertEquals(listOf("Starting again."), heard { repeat(4) { press(KeyEvent.KEYCODE_HEADSETHOOK) } })
    }

    @Test fun byChordsOfTheVolumeKeys() = ActivityScenario.launch(MainActivity::class.java).use { screen ->
        settle(1_000)
        var now = 0L
        fun key(code: Int, action: Int) = screen.onActivity { it.dispatchKeyEvent(KeyEvent(0, now, action, code, 0)) }
        fun chord(first: Int, second: Int, heldMs: Long = 150) {
            key(first, KeyEvent.ACTION_DOWN)
            now += 80
            key(second, KeyEvent.ACTION_DOWN)
            now += heldMs
            key(first, KeyEvent.ACTION_UP)
            key(second, KeyEvent.ACTION_UP)
        }
        fun alone(first: Int, second: Int, heldMs: Long = 150) {
            now += 5_000
            chord(first, second, heldMs)
        }
        assertEquals(listOf("Belt disconnected."), heard { alone(KEYCODE_VOLUME_UP, KEYCODE_VOLUME_DOWN) })
        assertEquals(listOf("Belt disconnected."), heard { alone(KEYCODE_VOLUME_DOWN, KEYCODE_VOLUME_UP) })
        assertEquals(
            listOf("Belt disconnected."), heard { alone(KEYCODE_VOLUME_UP, KEYCODE_VOLUME_DOWN, heldMs = 1_200) },
        )
        val twice = heard {
            alone(KEYCODE_VOLUME_UP, KEYCODE_VOLUME_DOWN)
            chord(KEYCODE_VOLUME_UP, KEYCODE_VOLUME_DOWN)
        }
        assertEquals("Muted. Danger is still spoken.", twice.last())
    }

    @Test fun inFirefighterModeAVolumeKeyAsksAloneAndAChordAsksOnce() = volumeKeysOfAFirefighter { press ->
        assertEquals(listOf("Belt disconnected."), heard { press(intArrayOf(KEYCODE_VOLUME_UP)) })
        assertEquals(listOf("No way back yet."), heard { press(intArrayOf(KEYCODE_VOLUME_DOWN)) })
        assertEquals(listOf("Belt disconnected."), heard { press(intArrayOf(KEYCODE_VOLUME_UP, KEYCODE_VOLUME_DOWN)) })
    }

    @Test fun inFirefighterModeWithoutChordsTwoKeysTogetherAskOnce() = volumeKeysOfAFirefighter { press ->
        container.settings.settings.value = container.settings.settings.value.copy(volumeKeys = false)
        settle(1_000)
        assertEquals(listOf("Belt disconnected."), heard { press(intArrayOf(KEYCODE_VOLUME_UP, KEYCODE_VOLUME_DOWN)) })
        assertEquals(listOf("No way back yet."), heard { press(intArrayOf(KEYCODE_VOLUME_DOWN, KEYCODE_VOLUME_UP)) })
    }

    /** What is not taken by the screen goes to guidance's media session, which asks a second time. */
    private fun volumeKeysOfAFirefighter(test: (press: (IntArray) -> Unit) -> Unit) =
        ActivityScenario.launch(MainActivity::class.java).use { screen ->
            container.settings.settings.value = container.settings.settings.value.copy(
                firefighter = true, notMovedAlertS = 0,
            )
            settle(1_000)
            var now = 0L
            fun key(code: Int, action: Int) = screen.onActivity {
                assertTrue("taken", it.dispatchKeyEvent(KeyEvent(0, now, action, code, 0)))
                now += 100
            }
            test { codes ->
                listOf(KeyEvent.ACTION_DOWN, KeyEvent.ACTION_UP).forEach { action -> codes.forEach { key(it, action) } }
            }
        }

    /** The chosen language is not the phone's, and nothing has been said in it yet. */
    @Test fun whatIsAskedWhileGuidanceIsOffIsAnsweredInTheChosenLanguage() {
        service.get().onStartCommand(NavigationService.intent(app, NavigationService.ACTION_STOP), 0, 2)
        settle(5_000)
        container.settings.settings.value = container.settings.settings.value.copy(language = Language.FRENCH)
        settle(1_000)
        assertEquals(listOf("Le guidage est arrêté."), heard { container.guide.ask(Ask.WHERE_AM_I) })
        assertEquals(listOf("Le guidage est arrêté."), heard { container.guide.ask(Ask.WAY_OUT) })
    }

    @Test fun byTheTile() {
        val tile = Robolectric.buildService(WhereAmITile::class.java).create().get()
        assertEquals(listOf("Belt disconnected."), heard(tile::onClick))
    }
}
