package org.echoway.app.control

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.NoStart
import org.echoway.app.guide.Message
import org.echoway.app.settings.Settings
import org.echoway.app.testing.MemorySettings
import org.echoway.app.testing.RecordingSiren
import org.echoway.app.testing.SamplePlan
import org.echoway.app.testing.VirtualClock
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test

/** Firefighter mode's watch over a wearer who may not move, in virtual time. */
@OptIn(ExperimentalCoroutinesApi::class)
class StillnessWatchTest {
    private inner class Watch(private val scope: TestScope, settings: Settings) {
        val settings = MemorySettings(settings)
        val siren = RecordingSiren()
        val told = mutableListOf<Pair<Double, Message>>()
        val clock = VirtualClock(scope.testScheduler)
        val states = MutableStateFlow<NavigationState>(NavigationState.Idle)
        val lookout = Lookout(siren, clock) { told += clock.nowS() to it }

        init {
            scope.backgroundScope.launch { lookout.run(states, this@Watch.settings.settings) }
            move()
        }

        fun move() {
            states.value = SamplePlan.running(
                clock.nowS(), SamplePlan.estimate(0, 1.0, 1.0),
            ).copy(movedS = clock.nowS())
            scope.runCurrent()
        }

        fun wait(seconds: Double) {
            scope.advanceTimeBy((seconds * 1000).toLong())
            scope.runCurrent()
        }
    }

    private fun watching(
        settings: Settings = Settings(firefighter = true, notMovedAlertS = 30),
        test: Watch.() -> Unit,
    ) =
        runTest { Watch(this, settings).test() }

    @Test fun itSaysWhatItIsNotAsSoonAsItWatches() =
        watching { assertEquals(listOf(Message.NotAPass), told.map { it.second }) }

    @Test fun warnsTenSecondsBeforeTheAlarm() = watching {
        wait(19.0)
        assertEquals(Stillness.MOVING, lookout.stillness.value)
        wait(1.5)
        assertEquals(Stillness.SOON, lookout.stillness.value)
        assertEquals(1, siren.warnings)
        assertEquals(20.0, told.single { it.second == Message.StillSoon }.first, 1.0)
        assertFalse(siren.sounding)
        wait(10.0)
        assertEquals(Stillness.ALARM, lookout.stillness.value)
        assertTrue(siren.sounding)
        assertEquals(30.0, told.first { it.second == Message.StillAlarm }.first, 1.0)
    }

    @Test fun whoMovesDuringTheWarningIsLeftAlone() = watching {
        wait(25.0)
        move()
        wait(1.0)
        assertEquals(Stillness.MOVING, lookout.stillness.value)
        wait(18.0)
        assertEquals(Stillness.MOVING, lookout.stillness.value)
        assertFalse(siren.sounding)
    }

    @Test fun theAlarmGoesOnWhenSomebodyElseMovesTheWearer() = watching {
        wait(31.0)
        move()
        wait(5.0)
        assertEquals(Stillness.ALARM, lookout.stillness.value)
        assertTrue(siren.sounding)
    }

    @Test fun theAlarmIsSaidAgainUntilItIsCancelled() = watching {
        wait(60.0)
        assertTrue("${told.size}", told.count { it.second == Message.StillAlarm } in 2..3)
        lookout.cancel()
        assertFalse(siren.sounding)
        assertEquals(Message.StillCancelled, told.last().second)
        wait(19.0)
        assertEquals("counts anew", Stillness.MOVING, lookout.stillness.value)
        wait(12.0)
        assertEquals(Stillness.ALARM, lookout.stillness.value)
    }

    @Test fun cancellingWithoutAnAlarmSaysNothing() = watching {
        lookout.cancel()
        assertEquals(listOf(Message.NotAPass), told.map { it.second })
    }

    @Test fun leavingTheModeEndsTheAlarm() = watching {
        wait(31.0)
        settings.settings.value = settings.settings.value.copy(firefighter = false)
        wait(0.5)
        assertFalse(siren.sounding)
        assertEquals(Stillness.MOVING, lookout.stillness.value)
        assertEquals("who relied on it is told", Message.WatchEnded, told.last().second)
        wait(120.0)
        assertFalse(siren.sounding)
    }

    /** Nobody's movements are seen then: the alarm would sound for whoever walks. */
    @Test fun guidanceThatFailsEndsTheWatchAndThatIsSaid() = watching {
        wait(5.0)
        states.value = NavigationState.Failed(NoStart.BUILDING_UNUSABLE, "")
        wait(60.0)
        assertFalse(siren.sounding)
        assertEquals(listOf(Message.NotAPass, Message.WatchEnded), told.map { it.second })
    }

    @Test fun neverMeansNever() = watching(Settings(firefighter = true, notMovedAlertS = 0)) {
        wait(600.0)
        assertEquals(emptyList<Pair<Double, Message>>(), told)
    }

    @Test fun aShortTimeHasAShortWarning() = watching(Settings(firefighter = true, notMovedAlertS = 10)) {
        wait(4.0)
        assertEquals(Stillness.MOVING, lookout.stillness.value)
        wait(2.0)
        assertEquals(Stillness.SOON, lookout.stillness.value)
    }
}
