package org.echoway.app.belt

import java.io.IOException
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.FlowCollector
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.flow.map
import org.echoway.app.Clock

/** A belt on the USB port: waits for it, asks once for permission, opens it, and starts over when it is gone. */
class UsbBeltSource(private val bus: UsbBus, private val clock: Clock) : BeltSource {
    override val bringsMotion = false

    override val events: Flow<BeltEvent> = flow {
        var askedFor: String? = null
        while (true) {
            val belt = bus.changes.map { bus.belt() }.first { it != null } ?: continue
            if (belt.permitted) {
                askedFor = null
                listen(belt)
            } else {
                if (askedFor != belt.id) {
                    askedFor = belt.id
                    emit(BeltEvent.PermissionMissing)
                    belt.requestPermission()
                }
                bus.changes.first { bus.belt()?.let { it.permitted || it.id != askedFor } ?: true }
                if (bus.belt() == null) emit(BeltEvent.Detached)
            }
        }
    }

    private suspend fun FlowCollector<BeltEvent>.listen(belt: UsbBelt) {
        try {
            belt.open().use { line -> relay(line) }
        } catch (_: IOException) {
            // Pulled out, or an adapter that drops out when the battery sags: both come back by themselves.
        }
        emit(BeltEvent.Detached)
        delay(REOPEN_PAUSE_MS)
    }

    private suspend fun FlowCollector<BeltEvent>.relay(line: SerialLine) {
        emit(BeltEvent.Attached)
        line.bytes.collect { emit(BeltEvent.Bytes(it, clock.nowS())) }
    }

    private companion object {
        /** So that a line which cannot be opened is not tried without a break. */
        const val REOPEN_PAUSE_MS = 500L
    }
}
