package org.echoway.app.testing

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.TestCoroutineScheduler
import org.echoway.app.Clock

/** The clock of a test's virtual time. */
@OptIn(ExperimentalCoroutinesApi::class)
class VirtualClock(private val scheduler: TestCoroutineScheduler) : Clock {
    override fun nowS() = scheduler.currentTime / 1000.0
}
