package org.echoway.app.engine

import org.echoway.core.Estimate
import org.echoway.core.MotionHint
import org.echoway.core.SensorHealth
import org.echoway.core.Start

/** Sees what goes through navigation, in order and on its thread. Must be quick. */
interface Witness {
    /** Some of [sensors] have fired: those whose time is new. */
    fun onFirings(sensors: List<SensorHealth>)

    fun onMotion(hint: MotionHint)

    fun onEstimate(estimate: Estimate)

    /** The wearer said where they stand, and the tracker starts over at [start]. */
    fun onRestart(start: Start, timeS: Double)
}
