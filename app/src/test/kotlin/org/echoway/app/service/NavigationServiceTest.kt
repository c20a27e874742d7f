package org.echoway.app.service

import android.app.Notification
import android.app.NotificationManager
import android.app.Service
import android.content.pm.ServiceInfo
import android.view.View
import android.widget.FrameLayout
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.util.concurrent.TimeUnit
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.runBlocking
import org.echoway.app.R
import org.echoway.app.belt.BeltEvent
import org.echoway.app.belt.BeltSource
import org.echoway.app.belt.WireSentence
import org.echoway.app.engine.Line
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Wish
import org.echoway.app.guide.Ask
import org.echoway.app.settings.Goal
import org.echoway.app.settings.SourceKind
import org.echoway.app.testing.ScriptedBelt
import org.echoway.app.touch.Touch
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Language
import org.echoway.core.RoutePreferences
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.Shadows.shadowOf
import org.robolectric.android.controller.ServiceController
import org.robolectric.annotation.Config
import org.robolectric.annotation.Implementation
import org.robolectric.annotation.Implements
import org.robolectric.shadows.ShadowLooper
import org.robolectric.shadows.ShadowPowerManager
import org.robolectric.shadows.ShadowService

@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class)
class NavigationServiceTest {
    private val app = ApplicationProvider.getApplicationContext<TestApp>()
    private val container get() = app.container
    private val services = mutableListOf<ServiceController<NavigationService>>()

    private fun command(action: String?): ServiceController<NavigationService> {
        val intent = action?.let { NavigationService.intent(app, it) }
        val controller = services.lastOrNull()
            ?: Robolectric.buildService(NavigationService::class.java).create().also { services += it }
        controller.get().onStartCommand(intent, 0, 1)
        settle()
        return controller
    }

    /** Lets the service's coroutines and the file threads behind them come to rest. */
    private fun settle(millis: Long = 300) {
        repeat(SETTLING_STEPS) {
            ShadowLooper.idleMainLooper(millis / SETTLING_STEPS, TimeUnit.MILLISECONDS)
            Thread.sleep(2)
        }
    }

    private fun awaitRunning(): NavigationState.Running {
        repeat(500) {
            (container.navigator.state.value as? NavigationState.Running)?.let { return it }
            settle(20)
        }
        throw AssertionError("navigation does not run: ${container.navigator.state.value}")
    }

    private fun echoes(seconds: Double) {
        var sequence = 0
        repeat((seconds * 16).toInt()) {
            container.belt.send(
                BeltEvent.Bytes(WireSentence.range(sequence, sequence % 15, 2.0), container.clock.nowS()),
            )
            sequence++
            ShadowLooper.idleMainLooper(62, TimeUnit.MILLISECONDS)
        }
    }

    private fun notification(): Notification =
        shadowOf(app.getSystemService(NotificationManager::class.java)).getNotification(NavigationNotification.ID)

    private fun text() = notification().extras.getCharSequence(Notification.EXTRA_TEXT).toString()

    @After fun stop() = services.forEach { it.destroy() }

    @Test fun startsInTheForegroundAndSaysThatItWaits() {
        val service = command(NavigationService.ACTION_START)
        awaitRunning()
        settle()
        assertEquals(NavigationNotification.ID, shadowOf(service.get()).lastForegroundNotificationId)
        assertEquals("Waiting for the belt.", text())
        assertEquals(listOf("Where am I?", "Way out", "Stop"), notification().actions.map { it.title.toString() })
        assertTrue(container.settings.settings.value.navigating)
    }

    @Test fun attachDetachAndReattachAreHeardAndFelt() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        container.belt.send(BeltEvent.Attached)
        echoes(3.0)
        assertTrue("${container.voice.words}", "Belt connected." in container.voice.words)
        container.belt.send(BeltEvent.Detached)
        settle(2_000)
        assertEquals("Belt disconnected.", container.voice.words.last())
        assertEquals(Touch.BELT_LOST, container.buzzer.felt.last())
        assertEquals("Belt disconnected.", text())
        settle(12_000)
        container.belt.send(BeltEvent.Attached)
        echoes(2.0)
        assertEquals(2, container.voice.words.count { it == "Belt connected." })
    }

    @Test fun permissionThatIsMissingIsToldInWordsAndOnTheNotification() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        container.belt.send(BeltEvent.PermissionMissing)
        settle(3_000)
        assertEquals(Line.PERMISSION_MISSING, awaitRunning().line)
        assertEquals("The belt waits for your permission.", text())
        assertTrue("Belt found. Allow its use on screen." in container.voice.words)
        container.belt.send(BeltEvent.PermissionRefused)
        settle(6_000)
        assertEquals("Belt refused. “Where am I?” asks again.", container.voice.words.last())
        assertEquals("Belt refused. “Where am I?” asks again.", text())
        command(NavigationService.actionOf(Ask.WHERE_AM_I))
        settle(6_000)
        assertEquals("Belt found. Allow its use on screen.", container.voice.words.last())
        assertEquals(1, container.belt.askedAgain)
    }

    @Test fun whereAmIIsAnsweredFromTheNotification() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        command(NavigationService.actionOf(Ask.WHERE_AM_I))
        settle(2_000)
        assertEquals("Belt disconnected.", container.voice.words.last())
    }

    @Test fun everyButtonOfTheNotificationAsks() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        settle()
        @Suppress("DEPRECATION") // for who builds it; who shows it reads it there
        val unfolded = notification().bigContentView.apply(app, FrameLayout(app))
        fun pressed(id: Int): String? {
            while (shadowOf(app).nextStartedService != null) Unit
            unfolded.findViewById<View>(id).performClick()
            return shadowOf(app).nextStartedService?.action
        }
        assertEquals(NavigationService.actionOf(Ask.REPEAT), pressed(R.id.repeat))
        assertEquals(NavigationService.actionOf(Ask.MUTE), pressed(R.id.mute))
        assertEquals(NavigationService.actionOf(Ask.WAY_BACK), pressed(R.id.way_back))
        val actions = notification().actions.map { shadowOf(it.actionIntent).savedIntent.action }
        assertEquals(
            listOf(
                NavigationService.actionOf(Ask.WHERE_AM_I),
                NavigationService.actionOf(Ask.WAY_OUT),
                NavigationService.ACTION_STOP,
            ),
            actions,
        )
    }

    @Test fun everyAskReachesTheGuide() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        settle(6_000)
        assertEquals("Waiting for the belt.", container.voice.words.last())
        val answers = mapOf(
            Ask.WHERE_AM_I to "Belt disconnected.",
            Ask.MUTE to "Muted. Danger is still spoken.",
            Ask.REPEAT to "Muted. Danger is still spoken.",
            Ask.WAY_BACK to "No way back yet.",
            Ask.STOP_LEADING to "No longer leading you.",
        )
        answers.forEach { (ask, words) ->
            command(NavigationService.actionOf(ask))
            settle(6_000)
            assertEquals("$ask", words, container.voice.words.last())
        }
        command(NavigationService.actionOf(Ask.WAY_OUT))
        settle(6_000)
        assertEquals("whoever asks hears why no way is told yet", "Belt disconnected.", container.voice.words.last())
        assertEquals(Wish.LeadTo(Destination.WAY_OUT), awaitRunning().leading)
    }

    /** "Replay" pressed twice while guidance is on. */
    @Test fun startedTwiceAtOnceWhileItRunsThereIsStillOneGuidance() {
        val service = command(NavigationService.ACTION_START).get()
        awaitRunning()
        var listeners = 0
        container.otherBelt = object : BeltSource {
            override val bringsMotion = true
            override val events = flow<BeltEvent> {
                listeners++
                try {
                    awaitCancellation()
                } finally {
                    listeners--
                }
            }
        }
        repeat(2) { service.onStartCommand(NavigationService.intent(app, NavigationService.ACTION_START), 0, 1) }
        settle(2_000)
        awaitRunning()
        assertEquals(1, listeners)
        command(NavigationService.ACTION_STOP)
        assertEquals("none goes on that nobody can stop", 0, listeners)
    }

    @Test fun startedAgainItTakesOverFromItself() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        container.belt = ScriptedBelt()
        command(NavigationService.ACTION_START)
        settle(1_000)
        awaitRunning()
    }

    @Test fun goesOnAfterTheSystemKilledItAndSaysThatItMustBeAskedTheWayAgain() {
        container.settings.settings.value = container.settings.settings.value.copy(
            navigating = true, source = SourceKind.USB,
        )
        container.belt = ScriptedBelt(bringsMotion = false)
        command(action = null)
        awaitRunning()
        settle(5_000)
        assertEquals("Guidance was interrupted. Ask the way again.", container.voice.words.first())
    }

    /** Guidance as Android brings it back after it had killed the app while it led there. */
    private fun broughtBack(goal: Goal?): NavigationState.Running {
        container.settings.settings.value =
            container.settings.settings.value.copy(
                navigating = true, source = SourceKind.USB, goal = goal, avoidStairs = true,
            )
        command(action = null)
        return awaitRunning()
    }

    @Test fun leadsOnToTheSameDestinationAfterTheSystemKilledIt() {
        val places = runBlocking { container.buildings.find("torgersen-lab")!! }.plan.places
        val lectern = Destination(DestinationKind.PLACE, places.indexOfFirst { it.name == "Lectern" })
        val goal = Goal("torgersen-lab", lectern)
        assertEquals(
            "from the first moment on",
            Wish.LeadTo(lectern, RoutePreferences(avoidStairs = true)),
            broughtBack(goal).leading,
        )
        settle(5_000)
        assertEquals("Guidance was interrupted. Destination stays: Lectern.", container.voice.words.first())
        assertEquals("and again, should it be killed again", goal, container.settings.settings.value.goal)
    }

    @Test fun aDestinationThatTheBuildingDoesNotHaveMustBeAskedAgain() {
        assertEquals(null, broughtBack(Goal("torgersen-lab", Destination(DestinationKind.PLACE, 999))).leading)
        settle(5_000)
        assertEquals("Guidance was interrupted. Ask the way again.", container.voice.words.first())
        assertEquals(null, container.settings.settings.value.goal)
    }

    @Test fun aDestinationOfAnotherBuildingMustBeAskedAgain() {
        assertEquals(null, broughtBack(Goal("westport-house", Destination.WAY_OUT)).leading)
    }

    @Test fun theDestinationIsKeptForAsLongAsTheWearerIsLed() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        fun keptAfter(action: String): Goal? {
            command(action)
            settle(2_000)
            return container.settings.settings.value.goal
        }
        val wayOut = Goal("torgersen-lab", Destination.WAY_OUT)
        assertEquals(wayOut, keptAfter(NavigationService.actionOf(Ask.WAY_OUT)))
        assertEquals(null, keptAfter(NavigationService.actionOf(Ask.STOP_LEADING)))
        assertEquals(wayOut, keptAfter(NavigationService.actionOf(Ask.WAY_OUT)))
        assertEquals("stopped for good", null, keptAfter(NavigationService.ACTION_STOP))
    }

    @Test fun whoeverWalkedOnBeforeTheSystemKilledItIsNotTakenToBeAtTheEntrance() {
        fun sureOfTheRoomAtTheFirstEcho(action: String?): Double {
            container.settings.settings.value =
                container.settings.settings.value.copy(
                    source = SourceKind.USB, entrance = "Main entrance", navigating = true,
                )
            container.belt = ScriptedBelt()
            command(action)
            awaitRunning()
            container.belt.send(BeltEvent.Attached)
            echoes(1.0 / 16)
            settle()
            return awaitRunning().estimate.roomProbability
        }
        assertTrue(sureOfTheRoomAtTheFirstEcho(NavigationService.ACTION_START) > 0.9)
        command(NavigationService.ACTION_STOP)
        settle(1_000)
        assertTrue(sureOfTheRoomAtTheFirstEcho(action = null) < 0.9)
    }

    /**
     * What a wearer hears first who begins by hand, [agoS] after the belt was last heard in an earlier life of the app.
     */
    private fun heardFirstByHand(agoS: Double?): String {
        container.settings.settings.value = container.settings.settings.value.copy(
            source = SourceKind.USB, entrance = "Main entrance", navigating = true,
            walkedS = agoS?.let { container.clock.nowS() - it }, goal = Goal("torgersen-lab", Destination.WAY_OUT),
        )
        command(NavigationService.ACTION_START)
        awaitRunning()
        settle(5_000)
        return container.voice.words.first()
    }

    @Test fun whoBeginsByHandSoonAfterTheAppsDeathGoesOn() {
        assertEquals("Guidance was interrupted. Destination stays: Way out.", heardFirstByHand(agoS = 120.0))
        assertEquals(Wish.LeadTo(Destination.WAY_OUT), awaitRunning().leading)
        container.belt.send(BeltEvent.Attached)
        echoes(1.0 / 16)
        settle()
        assertTrue("not taken to be at the entrance", awaitRunning().estimate.roomProbability < 0.9)
    }

    @Test fun whoBeginsByHandMuchLaterBeginsAnew() {
        assertEquals("Waiting for the belt.", heardFirstByHand(agoS = 3_600.0))
        assertEquals(null, awaitRunning().leading)
        assertEquals(null, container.settings.settings.value.goal)
    }

    @Test fun whoBeginsByHandAfterThePhoneWasSwitchedOffBeginsAnew() {
        assertEquals("the clock began anew", "Waiting for the belt.", heardFirstByHand(agoS = -3_600.0))
    }

    @Test fun whoNeverHeardTheBeltBeginsAnew() {
        assertEquals("Waiting for the belt.", heardFirstByHand(agoS = null))
    }

    @Test fun theWalkIsNotedWhileTheBeltIsHeardSoThatItGoesOn() {
        container.settings.settings.value = container.settings.settings.value.copy(source = SourceKind.USB)
        command(NavigationService.ACTION_START)
        awaitRunning()
        container.belt.send(BeltEvent.Attached)
        echoes(2.0)
        val noted = container.settings.settings.value.walkedS!!
        assertEquals(container.clock.nowS(), noted, 5.0)
        echoes(65.0)
        assertTrue("and again after a minute", container.settings.settings.value.walkedS!! > noted + 50.0)
        container.belt = ScriptedBelt()
        command(NavigationService.ACTION_START)
        settle(12_000)
        assertFalse(
            "begun again while guidance is on it begins anew", container.voice.words.any { "interrupted" in it },
        )
    }

    @Test fun withoutABuildingItSaysWhatIsMissing() {
        container.settings.settings.value = container.settings.settings.value.copy(building = null)
        command(NavigationService.ACTION_START)
        settle(3_000)
        assertEquals("Cannot start. Choose a building in the app.", container.voice.words.last())
    }

    @Test fun guidanceThatTheSystemDoesNotAllowIsHeardToBeOff() {
        val service = Robolectric.buildService(NavigationService::class.java).create().also { services += it }
        shadowOf(service.get()).setThrowInStartForeground(SecurityException("no connected device"))
        command(NavigationService.ACTION_START)
        settle(3_000)
        assertTrue(shadowOf(service.get()).isStoppedBySelf)
        assertEquals("Guidance is off.", container.voice.words.last())
    }

    /** Since Android 14 no device counts as connected before it is granted. */
    @Config(shadows = [NoConnectedDevice::class])
    @Test fun waitsForABeltThatIsNotPluggedInYet() {
        container.settings.settings.value = container.settings.settings.value.copy(source = SourceKind.USB)
        command(NavigationService.ACTION_START)
        awaitRunning()
    }

    @Implements(Service::class)
    class NoConnectedDevice : ShadowService() {
        @Implementation
        override fun startForeground(id: Int, notification: Notification, foregroundServiceType: Int) {
            if (foregroundServiceType == ServiceInfo.FOREGROUND_SERVICE_TYPE_CONNECTED_DEVICE) {
                throw SecurityException("no connected device")
            }
            super.startForeground(id, notification, foregroundServiceType)
        }
    }

    @Test fun doesNotComeBackWhenGuidanceWasOff() {
        val service = command(action = null)
        settle(1_000)
        assertTrue(shadowOf(service.get()).isStoppedBySelf)
        assertEquals(NavigationState.Idle, container.navigator.state.value)
    }

    @Test fun theNotificationFollowsTheLanguage() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        settle()
        container.settings.settings.value = container.settings.settings.value.copy(language = Language.GERMAN)
        settle()
        assertEquals("Warten auf den Gürtel.", text())
    }

    @Test fun theNotificationIsInTheChosenLanguage() {
        container.settings.settings.value = container.settings.settings.value.copy(language = Language.FRENCH)
        command(NavigationService.ACTION_START)
        awaitRunning()
        settle()
        assertEquals("En attente de la ceinture.", text())
        assertEquals(
            listOf("Où suis-je ?", "Vers la sortie", "Arrêter"), notification().actions.map { it.title.toString() },
        )
    }

    @Test fun theEndOfGuidanceIsHeard() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        command(NavigationService.ACTION_STOP)
        settle(3_000)
        assertEquals("Guidance is off.", container.voice.words.last())
    }

    @Test fun stopEndsGuidanceForGood() {
        val service = command(NavigationService.ACTION_START)
        awaitRunning()
        command(NavigationService.ACTION_STOP)
        settle(1_000)
        assertTrue(shadowOf(service.get()).isStoppedBySelf)
        assertFalse(container.settings.settings.value.navigating)
        assertEquals(NavigationState.Idle, container.navigator.state.value)
    }

    @Test fun keepsAwakeWhileTheBeltTalksAndLetsThePhoneSleepWhenItIsGone() {
        command(NavigationService.ACTION_START)
        awaitRunning()
        assertFalse("waiting needs no wake lock", ShadowPowerManager.getLatestWakeLock().isHeld)
        container.belt.send(BeltEvent.Attached)
        echoes(2.0)
        assertTrue(ShadowPowerManager.getLatestWakeLock().isHeld)
        container.belt.send(BeltEvent.Detached)
        settle(5_000)
        assertTrue("a belt may come back at once", ShadowPowerManager.getLatestWakeLock().isHeld)
        repeat(20) { settle(5_000) }
        assertFalse(ShadowPowerManager.getLatestWakeLock().isHeld)
    }

    private companion object {
        const val SETTLING_STEPS = 10
    }
}
