package org.echoway.app.ui.diagnostics

import android.content.res.Resources
import org.echoway.app.R
import org.echoway.app.guide.Side
import org.echoway.core.BeltHealth
import org.echoway.core.BeltLink
import org.echoway.core.SensorHealth
import org.echoway.core.SensorState

/**
 * The belt's health in words. Neither positions nor ranges are among them: together they would tell where somebody is.
 */
class DiagnosticsReport(private val resources: Resources) {
    fun belt(belt: BeltHealth): List<String> = listOf(
        resources.getString(belt.link.words),
        resources.getString(R.string.health_rate, belt.firingsPerSecond),
        resources.getString(R.string.health_good, belt.goodSentences),
        resources.getString(R.string.health_corrupt, belt.badChecksums, belt.malformed),
        resources.getString(R.string.health_lost, belt.lostFirings),
        resources.getString(R.string.health_restarts, belt.restarts),
        belt.temperatureC?.let { resources.getString(R.string.health_temperature, it) }
            ?: resources.getString(R.string.health_no_temperature),
        belt.batteryV?.let { resources.getString(R.string.health_battery, it) }
            ?: resources.getString(R.string.health_no_battery),
        if (belt.firmware.isEmpty()) {
            resources.getString(R.string.health_no_firmware)
        } else {
            resources.getString(R.string.health_firmware, belt.firmware)
        },
    )

    /** "3, left: good. 64 echoes of 64 firings in the last minute." */
    fun sensor(index: Int, sensors: List<SensorHealth>): String {
        val sensor = sensors[index]
        val side = resources.getStringArray(R.array.sides)[Side.of(index, sensors.size).ordinal]
        val state = resources.getString(sensor.state.words)
        val firings =
            resources.getQuantityString(R.plurals.health_echoes, sensor.firings, sensor.echoes, sensor.firings)
        val fault =
            if (sensor.faultCode != 0) " " + resources.getString(R.string.health_fault_code, sensor.faultCode) else ""
        return resources.getString(R.string.health_sensor, index + 1, side, state, firings) + fault
    }

    /** How many sensors can be relied on. */
    fun summary(belt: BeltHealth): String {
        val troubled = belt.sensors.count { it.state.isTrouble }
        return when {
            belt.sensors.isEmpty() -> resources.getString(R.string.health_nothing_heard)
            troubled == 0 -> resources.getString(R.string.health_all_good)
            else -> resources.getQuantityString(R.plurals.health_troubled, troubled, troubled, belt.sensors.size)
        }
    }

    /** All of it as text for a bug report; [about] names app and phone. */
    fun text(belt: BeltHealth, about: String): String {
        val sensors = belt.sensors.indices.map { sensor(it, belt.sensors) }
        return (listOf(about, summary(belt)) + belt(belt) + sensors).joinToString("\n")
    }

    private val BeltLink.words
        get() = when (this) {
            BeltLink.ABSENT -> R.string.health_link_absent
            BeltLink.CONNECTED -> R.string.health_link_connected
            BeltLink.LOST -> R.string.health_link_lost
        }
}

internal val SensorState.words
    get() = when (this) {
        SensorState.UNKNOWN -> R.string.sensor_unknown
        SensorState.GOOD -> R.string.sensor_good
        SensorState.SILENT -> R.string.sensor_silent
        SensorState.STUCK -> R.string.sensor_stuck
        SensorState.INTERFERENCE -> R.string.sensor_interference
        SensorState.FAULT -> R.string.sensor_fault
    }
