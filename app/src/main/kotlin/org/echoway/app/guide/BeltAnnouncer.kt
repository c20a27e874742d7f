package org.echoway.app.guide

import org.echoway.app.engine.Line
import org.echoway.app.engine.NavigationState
import org.echoway.core.BeltHealth
import org.echoway.core.BeltLink

/** Whether echoes arrive. */
val NavigationState.Running.hearsBelt get() = belt.link == BeltLink.CONNECTED && line == Line.OPEN

/** Tells of the belt: lost, back, a sensor blocked or clear again, battery low. */
internal class BeltAnnouncer {
    private var hearing: Boolean? = null
    private var waitingSinceS: Double? = null
    private var toldWaiting = false
    private var line = Line.WAITING
    private var troubled = emptySet<Int>()
    private var batteryToldLow = false

    fun reset() {
        hearing = null
        waitingSinceS = null
        toldWaiting = false
        line = Line.WAITING
        troubled = emptySet()
        batteryToldLow = false
    }

    fun onState(state: NavigationState.Running): List<Message> = buildList {
        addAll(lineMessages(state))
        if (state.hearsBelt) {
            addAll(sensorMessages(state.belt))
            addAll(batteryMessages(state.belt))
        }
    }

    private fun lineMessages(state: NavigationState.Running): List<Message> {
        val lineBefore = line
        val heardBefore = hearing
        line = state.line
        if (line == Line.REFUSED && lineBefore != line) return listOf(Message.BeltRefused)
        // Who is asked once more has wished for it, and was answered.
        if (line == Line.PERMISSION_MISSING && !lineBefore.isForbidden) return listOf(Message.BeltNotAllowed)
        if (line == Line.ENDED && lineBefore != line) {
            hearing = false
            return listOf(Message.RecordingOver)
        }
        if (state.hearsBelt) {
            hearing = true
            return if (heardBefore == true) emptyList() else listOf(Message.BeltBack)
        }
        // Not before it was heard once: until then there is nothing to lose.
        if (heardBefore == null) return waiting(state)
        if (!heardBefore) return emptyList()
        hearing = false
        return listOf(Message.BeltLost)
    }

    /** Whoever starts guidance and hears nothing must not take that for "all is well". */
    private fun waiting(state: NavigationState.Running): List<Message> {
        val since = waitingSinceS ?: state.timeS.also { waitingSinceS = it }
        if (toldWaiting || state.timeS - since < PATIENCE_S || state.line.isForbidden) return emptyList()
        toldWaiting = true
        return listOf(Message.WaitingForBelt)
    }

    private fun sensorMessages(belt: BeltHealth): List<Message> {
        val now = belt.sensors.indices.filter { belt.sensors[it].state.isTrouble }.toSet()
        val blocked = now - troubled
        val clear = troubled - now
        troubled = now
        val many = if (blocked.size > MANY) listOf(Message.SensorsBlocked(now.size)) else null
        return (many ?: blocked.sorted().map { Message.SensorBlocked(Side.of(it, belt.sensors.size), it) }) +
            clear.sorted().map { Message.SensorClear(Side.of(it, belt.sensors.size), it) }
    }

    private fun batteryMessages(belt: BeltHealth): List<Message> {
        val volts = belt.batteryV ?: return emptyList()
        if (volts > BATTERY_FINE_V) batteryToldLow = false
        if (volts >= BATTERY_LOW_V || batteryToldLow) return emptyList()
        batteryToldLow = true
        return listOf(Message.BatteryLow)
    }

    companion object {
        /** A belt that is plugged in is heard by then. */
        private const val PATIENCE_S = 3.0

        /** More sensors than this at once are one line, not one each. */
        private const val MANY = 2

        /** The ranging modules need 4.5 V at least; below this little is left of the belt's 6 V pack. */
        const val BATTERY_LOW_V = 5.2
        private const val BATTERY_FINE_V = 5.6
    }
}
