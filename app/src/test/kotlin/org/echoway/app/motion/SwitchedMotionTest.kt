package org.echoway.app.motion

import app.cash.turbine.test
import kotlinx.coroutines.channels.awaitClose
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.callbackFlow
import kotlinx.coroutines.test.runTest
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind
import org.junit.Assert.assertEquals
import org.junit.Test

class SwitchedMotionTest {
    private var sensorsOn = 0
    private var step: () -> Unit = {}

    private val sensors = MotionSource {
        callbackFlow {
            sensorsOn++
            step = { trySend(MotionHint(1.0, MotionKind.STEP, 1.0)) }
            awaitClose { sensorsOn-- }
        }
    }

    @Test fun theSensorsRestWhileTheSwitchIsOff() = runTest {
        val on = MutableStateFlow(true)
        SwitchedMotion(sensors, on).hints().test {
            testScheduler.runCurrent()
            step()
            assertEquals(MotionKind.STEP, awaitItem().kind)
            on.value = false
            testScheduler.runCurrent()
            assertEquals(0, sensorsOn)
            on.value = true
            testScheduler.runCurrent()
            assertEquals(1, sensorsOn)
            step()
            awaitItem()
        }
        assertEquals(0, sensorsOn)
    }
}
