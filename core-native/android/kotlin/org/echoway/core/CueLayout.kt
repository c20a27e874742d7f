package org.echoway.core

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Byte offsets of a cue in the buffer that the core fills; see `core-native/jni/layouts.hpp`. */
internal object CueLayout {
    /** Room for a line many times as long as any that is spoken; the core cuts what is longer. */
    const val BYTES = 4096
    private const val INTS = 40
    private const val TAIL = 80
    private const val WORDS = 96

    fun newBuffer(): ByteBuffer = ByteBuffer.allocateDirect(BYTES).order(ByteOrder.nativeOrder())

    fun read(from: ByteBuffer): Cue {
        fun double(index: Int) = from.getDouble(index * Double.SIZE_BYTES)
        fun int(index: Int) = from.getInt(INTS + index * Int.SIZE_BYTES)
        fun known(metres: Double) = metres.takeIf { it >= 0.0 }
        return Cue(
            timeS = double(0),
            direction = double(1).takeIf { int(2) != 0 },
            distanceM = known(double(2)),
            sigmaM = double(3),
            timeToLiveS = double(4),
            kind = CueKind.entries[int(0)],
            urgency = Urgency.entries[int(1)],
            up = int(3) != 0,
            count = int(4),
            room = int(5),
            landmark = CueLandmark(LandmarkKind.entries[int(6)], int(7)),
            tail = CueTail(CueKind.entries[int(9)], from.getDouble(TAIL), known(from.getDouble(TAIL + 8))).takeIf {
                int(8) != 0
            },
            words = words(from),
        )
    }

    private fun words(from: ByteBuffer): String {
        from.position(WORDS)
        return from.text().also { from.clear() }
    }
}
