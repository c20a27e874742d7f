package org.echoway.app.motion

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.emptyFlow
import kotlinx.coroutines.flow.flatMapLatest
import org.echoway.core.MotionHint

/** [source] while [on]; its sensors rest while it is off. */
class SwitchedMotion(private val source: MotionSource, private val on: Flow<Boolean>) : MotionSource {
    @OptIn(ExperimentalCoroutinesApi::class)
    override fun hints(): Flow<MotionHint> =
        on.distinctUntilChanged().flatMapLatest { if (it) source.hints() else emptyFlow() }
}
