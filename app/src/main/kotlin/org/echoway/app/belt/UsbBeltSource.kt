package org.echoway.app.belt

import java.io.IOException
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.FlowCollector
import kotlinx.coroutines.flow.MutableSharedFlow
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.merge
import kotlinx.coroutines.flow.withIndex
import org.echoway.app.Clock

/**
 * A belt on the USB port: waits for it, asks for permission at each plugging-in and when the wearer wishes to be asked
 * once more, opens it, and starts over when it is gone.
 */
class UsbBeltSource(private val bus: UsbBus, private val clock: Clock) : BeltSource {
    override val bringsMotion = false

    private val askedAgain = MutableSharedFlow<Unit>(extraBufferCapacity = 1)

    override fun askAgain() {
        askedAgain.tryEmit(Unit)
    }

    override val events: Flow<BeltEvent> = flow {
        while (true) {
            val belt = bus.changes.map { bus.belt() }.first { it != null } ?: continue
            if (belt.permitted) listen(belt) else awaitPermission(belt)
        }
    }

    /** Until the belt may be used or is gone. It is asked for only once the answer would be heard. */
    private suspend fun FlowCollector<BeltEvent>.awaitPermission(belt: UsbBelt) {
        merge(bus.changes.map { it == UsbChange.REFUSED }, askedAgain.map { null })
            .withIndex()
            .first { (index, refused) ->
                val now = bus.belt()
                val over = now?.id != belt.id || now.permitted
                when {
                    over -> Unit
                    index == 0 || refused == null -> ask(now)
                    refused -> emit(BeltEvent.PermissionRefused)
                }
                over
            }
        if (bus.belt() == null) emit(BeltEvent.Detached)
    }

    private suspend fun FlowCollector<BeltEvent>.ask(belt: UsbBelt) {
        emit(BeltEvent.PermissionMissing)
        belt.requestPermission()
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
