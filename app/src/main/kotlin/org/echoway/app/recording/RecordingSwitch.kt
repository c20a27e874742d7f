package org.echoway.app.recording

import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.distinctUntilChanged
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.engine.Witness
import org.echoway.core.Estimate
import org.echoway.core.MotionHint
import org.echoway.core.SensorHealth
import org.echoway.core.Start

/** Records a walk in [building] whenever that is wished for, each time under a new name. */
class RecordingSwitch(private val recordings: Recordings, private val building: InstalledBuilding) : Witness {
    @Volatile private var recorder: Recorder? = null

    /** Follows the wish until it is cancelled. */
    suspend fun follow(wished: Flow<Boolean>) = wished.distinctUntilChanged().collectLatest { on ->
        val started = (if (on) recordings.start(building) else null) ?: return@collectLatest
        recorder = started
        try {
            awaitCancellation()
        } finally {
            recorder = null
            recordings.stop(started)
        }
    }

    override fun onFirings(sensors: List<SensorHealth>) {
        recorder?.onFirings(sensors)
    }

    override fun onMotion(hint: MotionHint) {
        recorder?.onMotion(hint)
    }

    override fun onEstimate(estimate: Estimate) {
        recorder?.onEstimate(estimate)
    }

    override fun onRestart(start: Start, timeS: Double) {
        recorder?.onRestart(start, timeS)
    }
}
