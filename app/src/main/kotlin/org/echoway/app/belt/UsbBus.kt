package org.echoway.app.belt

import java.io.Closeable
import java.io.IOException
import kotlinx.coroutines.flow.Flow

/** Why to look at the USB port. */
enum class UsbChange {
    /** Something was plugged in, pulled out or allowed; or it is the first look. */
    LOOK,

    /** The wearer did not allow the belt's use. */
    REFUSED,
}

/** The phone's USB port, as far as a belt is concerned. */
interface UsbBus {
    /** Emits [UsbChange.LOOK] once at the start, then whenever something changes. */
    val changes: Flow<UsbChange>

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
