package org.echoway.app.belt

import java.io.Closeable
import java.io.IOException
import kotlinx.coroutines.flow.Flow

/** The phone's USB port, as far as a belt is concerned. */
interface UsbBus {
    /** Emits once at the start, then whenever something was plugged in, pulled out, allowed or refused. */
    val changes: Flow<Unit>

    /** The belt that is plugged in now. */
    fun belt(): UsbBelt?
}

/** A plugged-in belt. [id] differs after every plugging-in. */
interface UsbBelt {
    val id: String
    val permitted: Boolean

    /** Asks the wearer; the answer arrives through [UsbBus.changes]. */
    fun requestPermission()

    /** @throws IOException when the line cannot be opened */
    fun open(): SerialLine
}

/** An open line at the belt's baud rate. */
interface SerialLine : Closeable {
    /** Bytes as they arrive; fails with an [IOException] when the line goes away. */
    val bytes: Flow<ByteArray>
}
