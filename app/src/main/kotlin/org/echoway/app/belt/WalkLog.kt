package org.echoway.app.belt

import java.io.BufferedReader
import java.io.IOException
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind

/** A firing as a scan log tells it; [rangeM] is null when nothing answered. */
data class LoggedFiring(val timeS: Double, val sensor: Int, val rangeM: Double?)

/** A recorded walk: firings and motion hints, each in order of time. */
data class WalkLog(val sensors: Int, val firings: List<LoggedFiring>, val hints: List<MotionHint>) {
    companion object {
        const val DEFAULT_SENSORS = 15

        /**
         * A last line without its end was torn off by a crash, and is left out.
         *
         * @throws IOException with the line's number when a line is not what the format says
         */
        fun read(scans: BufferedReader, motion: BufferedReader? = null): WalkLog {
            var sensors = DEFAULT_SENSORS
            val firings = rows(scans, onComment = { comment ->
                Regex("sensors (\\d+)").matchEntire(comment)?.let { sensors = it.groupValues[1].toInt() }
            }) { (time, sensor, range) ->
                LoggedFiring(time.toDouble(), sensor.toInt(), range.ifEmpty { null }?.toDouble())
            }
            if (firings.isEmpty()) throw IOException("the log holds no firing")
            if (firings.any { it.sensor !in 0 until sensors }) throw IOException("the log names a sensor that its belt does not have")
            val hints = motion?.let { reader -> rows(reader) { (time, kind, value) -> hint(time.toDouble(), kind, value.toDouble()) } }
            return WalkLog(sensors, firings, hints.orEmpty())
        }

        private fun hint(timeS: Double, kind: String, value: Double) = when (kind) {
            "step" -> MotionHint(timeS, MotionKind.STEP, value)
            "yaw_rate_dps" -> MotionHint(timeS, MotionKind.YAW_RATE, Math.toRadians(value))
            "heading_deg" -> MotionHint(timeS, MotionKind.HEADING, Math.toRadians(value))
            else -> throw NumberFormatException("unknown kind $kind")
        }

        private fun <T> rows(reader: BufferedReader, onComment: (String) -> Unit = {}, row: (List<String>) -> T): List<T> {
            val rows = mutableListOf<T>()
            var header = true
            reader.use { it.readText() }.wholeLines().let { lines ->
                lines.forEachIndexed { index, line ->
                    when {
                        line.startsWith("#") -> onComment(line.drop(1).trim())
                        line.isBlank() -> Unit
                        header -> header = false
                        else -> rows += parsed(index + 1, line, row)
                    }
                }
            }
            return rows
        }

        private fun String.wholeLines() = if (endsWith('\n')) lines() else lines().dropLast(1)

        private fun <T> parsed(number: Int, line: String, row: (List<String>) -> T): T = try {
            row(line.trim().split(',').also { if (it.size < COLUMNS) throw NumberFormatException("too few columns") })
        } catch (e: NumberFormatException) {
            throw IOException("line $number: $line: ${e.message}", e)
        }

        private const val COLUMNS = 3
    }
}
