package org.echoway.app.recording

import java.io.Closeable
import java.io.File
import java.io.IOException
import java.util.Locale
import org.echoway.app.engine.Witness
import org.echoway.core.Estimate
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind
import org.echoway.core.Plan
import org.echoway.core.SensorHealth
import org.echoway.core.Start
import org.echoway.core.TrackState

/**
 * Writes a walk down as the contract's logs: [name].scans.csv, [name].motion.csv and [name].track.csv in [folder].
 * Times count from the first thing that happened, so that a log does not tell for how long the phone has been on. It
 * may be closed from another thread; what comes afterwards is not written.
 *
 * @param onFailed called once, when the disk is full or a file cannot be written; what was written so far stays
 */
class Recorder(
    private val folder: File,
    private val name: String,
    private val building: String,
    private val plan: Plan,
    private val onFailed: (IOException) -> Unit,
) : Witness, Closeable {
    private var startS = Double.NaN
    private var scans: LogFile? = null
    private var motion: LogFile? = null
    private var track: LogFile? = null
    private val early = mutableListOf<String>() // restarts before the first firing
    private var sensorsInHead = 0
    private var newestS = DoubleArray(0)
    private var closed = false

    override fun onFirings(sensors: List<SensorHealth>) = writing {
        if (sensors.size != newestS.size) newestS = DoubleArray(sensors.size) { Double.NEGATIVE_INFINITY }
        val fired = sensors.withIndex()
            .filter { (i, it) -> it.lastTimeS >= 0 && it.lastTimeS > newestS[i] }
            .sortedBy { it.value.lastTimeS }
        for ((index, sensor) in fired) {
            newestS[index] = sensor.lastTimeS
            scanLog(sensors.size).row(since(sensor.lastTimeS)) {
                "${number(it)},$index,${sensor.lastRangeM?.let(::number).orEmpty()}"
            }
        }
    }

    override fun onMotion(hint: MotionHint) = writing {
        val time = since(hint.timeS)
        val log = motion ?: open(Recordings.MOTION, listOf("time_s,kind,value")).also { motion = it }
        val (kind, value) = when (hint.kind) {
            MotionKind.STEP -> "step" to hint.value
            MotionKind.YAW_RATE -> "yaw_rate_dps" to Math.toDegrees(hint.value)
            MotionKind.HEADING -> "heading_deg" to Math.toDegrees(hint.value)
        }
        log.row(time) { "${number(it)},$kind,${number(value)}" }
    }

    /** Nothing is written while no room is known. */
    override fun onEstimate(estimate: Estimate) = writing {
        val room = plan.rooms.getOrNull(estimate.room) ?: return@writing
        val time = since(estimate.timeS)
        val log = track
            ?: open(Recordings.TRACK, listOf("time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state")).also {
                track = it
            }
        val values =
            listOf(estimate.x, estimate.y, Math.toDegrees(estimate.heading), estimate.sigmaM, estimate.roomProbability)
        log.row(time) {
            "${number(it)},${room.id},${values.joinToString(",", transform = ::number)},${estimate.state.word}"
        }
    }

    /** A comment line among the firings, which whoever replays the walk obeys. */
    override fun onRestart(start: Start, timeS: Double) = writing {
        val time = since(timeS)
        val room = plan.rooms.getOrNull(start.room)?.id
        val values = listOf(start.at?.x, start.at?.y, start.heading?.let(Math::toDegrees))
        fun line(timeS: Double) =
            "# restart ${number(timeS)} ${room ?: "-"} ${values.joinToString(" ") { it?.let(::number) ?: "-" }}"
        scans?.row(time, ::line) ?: early.add(line(time))
    }

    override fun close() = writing {
        closed = true
        listOf(scans, motion, track).forEach { it?.close() }
    }

    /** A belt may say how many sensors it has after some have fired; those rows are its own too. */
    private fun scanLog(sensors: Int): LogFile {
        val before = scans
        if (before != null && sensors == sensorsInHead) return before
        before?.close()
        val head = listOf("# building $building", "# sensors $sensors")
        val rows = if (before == null) {
            listOf("time_s,sensor,range_m") + early
        } else {
            File(folder, name + Recordings.SCANS).readLines().drop(head.size)
        }
        sensorsInHead = sensors
        return open(Recordings.SCANS, head + rows).also { scans = it }
    }

    private fun open(kind: String, head: List<String>) = LogFile(File(folder, name + kind), head)

    private fun since(timeS: Double): Double {
        if (startS.isNaN()) startS = timeS
        // A hint may be a little older than the firing that came first.
        return maxOf(0.0, timeS - startS)
    }

    /** A walk goes on though it cannot be written down. */
    private inline fun writing(write: () -> Unit) {
        synchronized(this) {
            if (closed) return
            try {
                write()
            } catch (e: IOException) {
                closed = true
                listOf(scans, motion, track).forEach { runCatching { it?.close() } }
                onFailed(e)
            }
        }
    }

    private companion object {
        /** 0.1 ms, 0.1 mm: below what a sensor resolves. */
        fun number(value: Double) = "%.4f".format(Locale.ROOT, value)

        val TrackState.word get() = name.lowercase(Locale.ROOT)
    }
}
