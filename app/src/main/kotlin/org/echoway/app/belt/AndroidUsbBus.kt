package org.echoway.app.belt

import android.app.PendingIntent
import android.content.BroadcastReceiver
import android.content.Context
import android.content.Intent
import android.content.IntentFilter
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbManager
import androidx.core.content.ContextCompat
import com.hoho.android.usbserial.driver.UsbSerialDriver
import com.hoho.android.usbserial.driver.UsbSerialPort
import com.hoho.android.usbserial.driver.UsbSerialProber
import com.hoho.android.usbserial.util.SerialInputOutputManager
import java.io.IOException
import kotlinx.coroutines.channels.awaitClose
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.buffer
import kotlinx.coroutines.flow.callbackFlow

/** The phone's USB port through usb-serial-for-android. [probe] finds the driver of a device, or null. */
class AndroidUsbBus(
    private val context: Context,
    private val probe: (UsbDevice) -> UsbSerialDriver? = UsbSerialProber.getDefaultProber()::probeDevice,
) : UsbBus {
    private val manager = context.getSystemService(UsbManager::class.java)

    override val changes: Flow<UsbChange> = callbackFlow {
        val receiver = object : BroadcastReceiver() {
            override fun onReceive(context: Context, intent: Intent) {
                trySend(if (intent.isRefusal) UsbChange.REFUSED else UsbChange.LOOK)
            }
        }
        val filter = IntentFilter().apply {
            addAction(UsbManager.ACTION_USB_DEVICE_ATTACHED)
            addAction(UsbManager.ACTION_USB_DEVICE_DETACHED)
            addAction(ACTION_PERMISSION)
        }
        ContextCompat.registerReceiver(context, receiver, filter, ContextCompat.RECEIVER_NOT_EXPORTED)
        trySend(UsbChange.LOOK)
        awaitClose { context.unregisterReceiver(receiver) }
    }

    override fun belt(): UsbBelt? =
        manager.deviceList.values.firstNotNullOfOrNull { device -> probe(device)?.let { Belt(device, it) } }

    private inner class Belt(private val device: UsbDevice, private val driver: UsbSerialDriver) : UsbBelt {
        /** Android gives a device a new name at every plugging-in. */
        override val id: String get() = device.deviceName
        override val permitted: Boolean get() = manager.hasPermission(device)

        override fun requestPermission() {
            // Mutable, because the system adds the answer; to this package alone, because a mutable intent
            // must be explicit.
            val answer = Intent(ACTION_PERMISSION).setPackage(context.packageName)
            manager.requestPermission(
                device, PendingIntent.getBroadcast(context, 0, answer, PendingIntent.FLAG_MUTABLE),
            )
        }

        override fun open(): SerialLine {
            val connection = manager.openDevice(device) ?: throw IOException("the USB device cannot be opened")
            val port = driver.ports.firstOrNull() ?: throw IOException("the USB device has no serial port")
            try {
                port.open(connection)
                port.setParameters(BAUD, DATA_BITS, UsbSerialPort.STOPBITS_1, UsbSerialPort.PARITY_NONE)
                // Boards with native USB send only once the host says that it listens.
                runCatching { port.setDTR(true) }
            } catch (e: IOException) {
                runCatching { port.close() }
                throw e
            }
            return UsbLine(port)
        }
    }

    private val Intent.isRefusal
        get() = action == ACTION_PERMISSION && !getBooleanExtra(UsbManager.EXTRA_PERMISSION_GRANTED, false)

    private companion object {
        const val ACTION_PERMISSION = "org.echoway.app.USB_PERMISSION"
        const val BAUD = 38_400
        const val DATA_BITS = 8
    }
}

/** Reads on the library's own thread until it is closed or fails; a new one is made after every attachment. */
private class UsbLine(private val port: UsbSerialPort) : SerialLine {
    override val bytes: Flow<ByteArray> = callbackFlow {
        val manager = SerialInputOutputManager(
            port,
            object : SerialInputOutputManager.Listener {
                override fun onNewData(data: ByteArray) {
                    trySend(data)
                }

                override fun onRunError(e: Exception) {
                    close(e as? IOException ?: IOException(e))
                }
            },
        )
        manager.setReadTimeout(0)
        manager.start()
        awaitClose {
            manager.stop()
            runCatching { port.close() } // ends the blocking read
        }
    }.buffer(CHUNKS_IN_FLIGHT)

    override fun close() {
        runCatching { port.close() }
    }

    private companion object {
        const val CHUNKS_IN_FLIGHT = 256
    }
}
