package org.echoway.core

import java.nio.ByteBuffer

/**
 * The native methods, as `core-native/jni/jni_entry.cpp` defines them. Nothing else calls them but [CoreSession] and
 * [PlanLoader], which own the rules: handles are checked, buffers are direct, times are seconds on one monotonic clock.
 */
internal object NativeCore {
    const val BAD_HANDLE = -1
    const val BAD_BUFFER = -2
    const val FAILED = -3

    init {
        System.loadLibrary("echoway_jni")
    }

    @JvmStatic external fun plan(folder: String, out: ByteBuffer, error: Array<String?>): Int

    @JvmStatic
    external fun open(
        folder: String,
        sensors: Int,
        radiusM: Double,
        beamRad: Double,
        slotS: Double,
        temperatureC: Double,
        room: Int,
        x: Double,
        y: Double,
        heading: Double,
        seed: Long,
        error: Array<String?>,
    ): Long

    @JvmStatic
    external fun withBelt(
        handle: Long,
        sensors: Int,
        radiusM: Double,
        beamRad: Double,
        slotS: Double,
        room: Int,
        x: Double,
        y: Double,
        heading: Double,
        error: Array<String?>,
    ): Long

    @JvmStatic external fun close(handle: Long)

    @JvmStatic external fun onBytes(
        handle: Long,
        bytes: ByteBuffer,
        length: Int,
        arrivalS: Double,
        estimateOut: ByteBuffer,
    ): Int

    @JvmStatic external fun onMotion(
        handle: Long,
        kind: Int,
        value: Double,
        timeS: Double,
        estimateOut: ByteBuffer,
    ): Int

    @JvmStatic external fun onTick(handle: Long, nowS: Double, estimateOut: ByteBuffer): Int

    @JvmStatic external fun onBelt(handle: Long, attached: Boolean, nowS: Double, estimateOut: ByteBuffer): Int

    @JvmStatic
    external fun restart(
        handle: Long,
        room: Int,
        x: Double,
        y: Double,
        heading: Double,
        estimateOut: ByteBuffer,
        error: Array<String?>,
    ): Int

    @JvmStatic external fun beltHealth(handle: Long, out: ByteBuffer): Int

    @JvmStatic external fun check(folder: String, out: ByteBuffer): Int

    /** Bytes written; 0 when there is no cue. */
    @JvmStatic external fun nextCue(handle: Long, language: Int, direction: Int, length: Int, out: ByteBuffer): Int

    @JvmStatic external fun setDestination(
        handle: Long,
        kind: Int,
        index: Int,
        avoidStairs: Boolean,
        error: Array<String?>,
    ): Int

    @JvmStatic external fun backTrack(handle: Long, error: Array<String?>): Int

    @JvmStatic external fun clearDestination(handle: Long): Int

    @JvmStatic external fun whereAmI(handle: Long): Int

    @JvmStatic external fun repeat(handle: Long): Int

    @JvmStatic external fun hasDestination(handle: Long): Int

    @JvmStatic external fun obstacleAhead(handle: Long): Double

    @JvmStatic external fun route(handle: Long, out: ByteBuffer): Int

    @JvmStatic external fun breadcrumbs(handle: Long, out: ByteBuffer): Int

    @JvmStatic external fun hypotheses(handle: Long, out: ByteBuffer): Int

    @JvmStatic external fun scan(handle: Long, out: ByteBuffer): Int
}
