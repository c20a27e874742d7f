package org.echoway.core

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Byte offsets of an estimate in the buffer that the core fills; see `core-native/jni/layouts.hpp`. */
internal object EstimateLayout {
    const val BYTES = 104
    private const val ROOM = 96
    private const val STATE = 100
    private val STATES = TrackState.entries

    fun newBuffer(): ByteBuffer = ByteBuffer.allocateDirect(BYTES).order(ByteOrder.nativeOrder())

    fun read(from: ByteBuffer): Estimate {
        fun double(index: Int) = from.getDouble(index * Double.SIZE_BYTES)
        return Estimate(
            timeS = double(0),
            x = double(1),
            y = double(2),
            heading = double(3),
            sigmaM = double(4),
            sigmaHeading = double(5),
            roomProbability = double(6),
            covarianceXx = double(7),
            covarianceXy = double(8),
            covarianceYy = double(9),
            speedMps = double(10),
            soundSpeedScale = double(11),
            room = from.getInt(ROOM),
            state = STATES[from.getInt(STATE)],
        )
    }
}
