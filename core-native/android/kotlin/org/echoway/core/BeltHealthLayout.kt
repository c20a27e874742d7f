package org.echoway.core

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Byte offsets of the belt's health in the buffer that the core fills; see `core-native/jni/layouts.hpp`. */
internal object BeltHealthLayout {
    private const val MAX_SENSORS = 64
    private const val HEADER_BYTES = 104
    private const val SENSOR_BYTES = 32
    const val BYTES = HEADER_BYTES + MAX_SENSORS * SENSOR_BYTES

    private const val SENSOR_COUNT = 4
    private const val RATE = 8
    private const val COUNTERS = 16
    private const val HAS_TEMPERATURE = 56
    private const val HAS_BATTERY = 60
    private const val TEMPERATURE = 64
    private const val BATTERY = 72
    private const val FIRMWARE = 80
    private const val FIRMWARE_BYTES = 24

    fun newBuffer(): ByteBuffer = ByteBuffer.allocateDirect(BYTES).order(ByteOrder.nativeOrder())

    fun read(from: ByteBuffer): BeltHealth {
        fun counter(index: Int) = from.getLong(COUNTERS + index * Long.SIZE_BYTES)
        return BeltHealth(
            link = BeltLink.entries[from.getInt(0)],
            firingsPerSecond = from.getDouble(RATE),
            goodSentences = counter(0),
            badChecksums = counter(1),
            malformed = counter(2),
            lostFirings = counter(3),
            restarts = counter(4),
            temperatureC = from.getDouble(TEMPERATURE).takeIf { from.getInt(HAS_TEMPERATURE) != 0 },
            batteryV = from.getDouble(BATTERY).takeIf { from.getInt(HAS_BATTERY) != 0 },
            firmware = firmware(from),
            sensors = List(from.getInt(SENSOR_COUNT).coerceIn(0, MAX_SENSORS)) {
                sensor(from, HEADER_BYTES + it * SENSOR_BYTES)
            },
        )
    }

    private fun firmware(from: ByteBuffer): String {
        val bytes = ByteArray(FIRMWARE_BYTES) { from.get(FIRMWARE + it) }
        return String(bytes, 0, bytes.indexOf(0).takeIf { it >= 0 } ?: FIRMWARE_BYTES, Charsets.US_ASCII)
    }

    private fun sensor(from: ByteBuffer, at: Int) = SensorHealth(
        state = SensorState.entries[from.getInt(at)],
        firings = from.getInt(at + 4),
        echoes = from.getInt(at + 8),
        faultCode = from.getInt(at + 12),
        lastRangeM = from.getDouble(at + 16).takeIf { it >= 0.0 },
        lastTimeS = from.getDouble(at + 24),
    )
}
