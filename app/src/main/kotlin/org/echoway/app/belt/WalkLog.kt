package org.echoway.app.belt

import java.io.BufferedReader
import java.io.IOException
import org.echoway.core.BeltSetup
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind
import org.echoway.core.Plan
import org.echoway.core.Point
import org.echoway.core.Start

/** A firing as a scan log tells it; [rangeM] is null when nothing answered. */
data class LoggedFiring(val timeS: Double, val sensor: Int, val rangeM: Double?)

/** Where the wearer said that they stand, in [room] by id; null: anywhere. */
data class LoggedRestart(val timeS: Double, val room: String?, val at: Point?, val heading: Double?) {
    /** In [plan], or null when that has no such room. */
    fun startIn(plan: Plan): Start? {
        val index = if (room == null) Plan.NO_ROOM else plan.rooms.indexOfFirst { it.id == room }
        return if (room != null && index < 0) null else Start(index, at, heading)
    }
}

/** A recorded walk: its belt, and firings, motion hints and restarts, each in order of time. */
data class WalkLog(
    val belt: BeltSetup,
    val firings: List<LoggedFiring>,
    val hints: List<MotionHint>,
    val restarts: List<LoggedRestart> = emptyList(),
) {
    companion object {
        /**
         * A last line without its end was torn off by a crash: a number in it may lack digits. It is left out.
         *
         * @throws IOException with the line's number when a line is not what the format says
         */
        fun read(scans: BufferedReader, motion: BufferedReader? = null): WalkLog {
            var belt = BeltSetup()
            val restarts = mutableListOf<LoggedRestart>()
            val firings = rows(scans, SCAN_COLUMNS, onComment = { comment, beforeHeader ->
                if (beforeHeader) belt = withComment(belt, comment)
                restart(comment)?.let(restarts::add)
            }) { (time, sensor, range) ->
                LoggedFiring(number(time), sensor.toInt(), range.ifEmpty { null }?.let(::length))
            }
            if (firings.isEmpty()) throw IOException("the log holds no firing")
            if (firings.any { it.sensor !in 0 until belt.sensors }) {
                throw IOException("the log names a sensor that its belt does not have")
            }
            val hints = motion?.let { reader ->
                rows(reader, MOTION_COLUMNS) { (time, kind, value) -> hint(number(time), kind, number(value)) }
            }
            return WalkLog(belt, firings, hints.orEmpty(), restarts)
        }

        /** `key value` says what belt it was, as docs/formats.md has it; any other comment is prose. */
        private fun withComment(belt: BeltSetup, comment: String): BeltSetup {
            val (key, word) = words(comment).takeIf { it.size == 2 } ?: return belt
            fun value(range: ClosedFloatingPointRange<Double>, unit: Double = 0.0) = number(word).also {
                if (it !in range || unit > 0.0 && it % unit != 0.0) {
                    throw NumberFormatException("$word is no sensible value for $key")
                }
            }
            return when (key) {
                "sensors" -> belt.copy(sensors = value(1.0..MAX_SENSORS, unit = 1.0).toInt())
                "radius_m" -> belt.copy(radiusM = value(0.0..2.0))
                "beam_deg" -> belt.copy(beamRad = Math.toRadians(value(0.01..360.0)))
                "slot_s" -> belt.copy(slotS = value(1e-6..60.0))
                "temperature_c" -> belt.copy(temperatureC = value(-60.0..100.0))
                else -> belt
            }
        }

        private fun words(comment: String) = comment.split(' ', '\t').filter { it.isNotEmpty() }

        /**
         * `restart time_s room x_m y_m heading_deg`, a `-` where something was not said; any other comment is prose.
         */
        private fun restart(comment: String): LoggedRestart? {
            val words = words(comment)
            if (words.size != RESTART_WORDS || words[0] != "restart") return null
            val (x, y, heading) = words.drop(3).map { word -> if (word == "-") null else number(word) }
            val at = if (x != null && y != null) Point(x, y) else null
            return LoggedRestart(number(words[1]), words[2].takeIf { it != "-" }, at, heading?.let(Math::toRadians))
        }

        private fun hint(timeS: Double, kind: String, value: Double) = when (kind) {
            "step" ->
                if (value == 1.0) {
                    MotionHint(timeS, MotionKind.STEP, value)
                } else {
                    throw NumberFormatException("a step of $value, not 1")
                }
            "yaw_rate_dps" -> MotionHint(timeS, MotionKind.YAW_RATE, Math.toRadians(value))
            "heading_deg" -> MotionHint(timeS, MotionKind.HEADING, Math.toRadians(value))
            else -> throw NumberFormatException("unknown kind $kind")
        }

        private fun <T> rows(
            reader: BufferedReader,
            columns: List<String>,
            onComment: (String, Boolean) -> Unit = { _, _ -> },
            row: (List<String>) -> T,
        ): List<T> {
            val rows = mutableListOf<T>()
            var header = true
            var timeS = Double.NEGATIVE_INFINITY
            fun take(fields: List<String>) {
                if (fields.size < columns.size) throw NumberFormatException("too few columns")
                val time = number(fields[0])
                if (time < timeS) throw NumberFormatException("time_s goes back")
                timeS = time
                rows += row(fields)
            }
            reader.use { it.readText() }.removePrefix(BYTE_ORDER_MARK).wholeLines().forEachIndexed { index, line ->
                numbered(index + 1, line) {
                    val fields = line.split(',').map { it.trim() }
                    when {
                        line.startsWith("#") -> onComment(line.drop(1).trim(), header)
                        line.isBlank() -> Unit
                        !header -> take(fields)
                        fields.take(columns.size) == columns -> header = false
                        else -> throw NumberFormatException("the header line must be '${columns.joinToString(",")}'")
                    }
                }
            }
            return rows
        }

        private fun String.wholeLines() = if (endsWith('\n')) lines() else lines().dropLast(1)

        /** Only decimal and finite: Java would read `NaN`, `0x1p3` and `1f` as well. */
        private fun number(text: String): Double {
            val value = if (DECIMAL.matches(text)) text.toDouble() else Double.NaN
            if (!value.isFinite()) throw NumberFormatException("$text is not a number")
            return value
        }

        private fun length(text: String) =
            number(text).also { if (it < 0.0) throw NumberFormatException("a range of $text m") }

        private fun <T> numbered(number: Int, line: String, read: () -> T): T = try {
            read()
        } catch (e: NumberFormatException) {
            throw IOException("line $number: $line: ${e.message}", e)
        }

        private val DECIMAL = Regex("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")
        private val SCAN_COLUMNS = listOf("time_s", "sensor", "range_m")
        private val MOTION_COLUMNS = listOf("time_s", "kind", "value")
        private const val BYTE_ORDER_MARK = "\uFEFF"
        private const val RESTART_WORDS = 6
        private const val MAX_SENSORS = 64.0
    }
}
