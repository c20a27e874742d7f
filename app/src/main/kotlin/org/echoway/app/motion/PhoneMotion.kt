package org.echoway.app.motion

import android.hardware.Sensor
import android.hardware.SensorEvent
import android.hardware.SensorEventListener
import android.hardware.SensorManager
import kotlinx.coroutines.channels.awaitClose
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.buffer
import kotlinx.coroutines.flow.callbackFlow
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind

/** What moves the wearer, as far as the phone's own sensors know. */
fun interface MotionSource {
    /** Cold: sensors are on while it is collected. Never emits on a phone that has none. */
    fun hints(): Flow<MotionHint>
}

/**
 * Steps from the step detector; turn rate about the vertical from gyroscope and gravity, so that it is right however
 * the phone sits in its pocket. Sensors that are missing or not allowed are left out.
 */
class PhoneMotion(private val manager: SensorManager, private val stepsAllowed: () -> Boolean) : MotionSource {
    override fun hints(): Flow<MotionHint> = callbackFlow {
        val yaw = YawRate()
        val listener = object : SensorEventListener {
            override fun onSensorChanged(event: SensorEvent) {
                val timeS = event.timestamp / 1e9
                when (event.sensor.type) {
                    Sensor.TYPE_STEP_DETECTOR -> trySend(MotionHint(timeS, MotionKind.STEP, 1.0))
                    Sensor.TYPE_GRAVITY -> yaw.gravity(event.values)
                    Sensor.TYPE_GYROSCOPE ->
                        yaw.rate(event.values, timeS)?.let { trySend(MotionHint(timeS, MotionKind.YAW_RATE, it)) }
                }
            }

            override fun onAccuracyChanged(sensor: Sensor, accuracy: Int) = Unit
        }
        val types = buildList {
            if (stepsAllowed()) add(Sensor.TYPE_STEP_DETECTOR)
            add(Sensor.TYPE_GRAVITY)
            add(Sensor.TYPE_GYROSCOPE)
        }
        // Wake-up variants would keep the phone awake; the wake lock that the service holds is enough.
        types.mapNotNull(manager::getDefaultSensor).forEach { manager.registerListener(listener, it, SAMPLING_US) }
        awaitClose { manager.unregisterListener(listener) }
    }.buffer(HINTS_IN_FLIGHT)

    private companion object {
        const val SAMPLING_US = 20_000
        const val HINTS_IN_FLIGHT = 256
    }
}
