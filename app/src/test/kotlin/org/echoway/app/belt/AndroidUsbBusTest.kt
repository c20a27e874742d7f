package org.echoway.app.belt

import android.content.Context
import android.content.Intent
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbManager
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import app.cash.turbine.test
import com.hoho.android.usbserial.driver.UsbSerialDriver
import com.hoho.android.usbserial.driver.UsbSerialPort
import java.io.IOException
import kotlinx.coroutines.test.runTest
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertNull
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.shadow.api.Shadow
import org.robolectric.shadows.ShadowLooper
import org.robolectric.util.ReflectionHelpers

@RunWith(AndroidJUnit4::class)
class AndroidUsbBusTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val manager = context.getSystemService(UsbManager::class.java)
    private val device: UsbDevice = Shadow.newInstanceOf(UsbDevice::class.java).also {
        ReflectionHelpers.setField(it, "mName", "/dev/bus/usb/001/002")
    }

    /** A port that refuses the belt's baud rate. */
    private class Port : UsbSerialPort {
        var closed = false

        override fun open(connection: UsbDeviceConnection?) = Unit

        override fun close() {
            closed = true
        }

        override fun setParameters(baudRate: Int, dataBits: Int, stopBits: Int, parity: Int) =
            throw IOException("$baudRate")

        override fun setDTR(value: Boolean) = Unit

        override fun setRTS(value: Boolean) = Unit
    }

    private val port = Port()
    private val driver = object : UsbSerialDriver {
        override fun getDevice() = this@AndroidUsbBusTest.device

        override fun getPorts() = listOf<UsbSerialPort>(port)
    }
    private val bus = AndroidUsbBus(context) { driver }

    @Test fun findsTheDeviceThatADriverKnows() {
        assertNull(bus.belt())
        shadowOf(manager).addOrUpdateUsbDevice(device, true)
        assertEquals(true, bus.belt()?.permitted)
        assertNull(AndroidUsbBus(context) { null }.belt())
    }

    @Test fun permissionIsAskedOfTheSystem() {
        shadowOf(manager).addOrUpdateUsbDevice(device, false)
        val belt = bus.belt()!!
        assertFalse(belt.permitted)
        belt.requestPermission()
        shadowOf(manager).addOrUpdateUsbDevice(device, true) // the wearer agrees
        assertTrue(bus.belt()!!.permitted)
    }

    @Test fun tellsOfEveryPluggingInAndPullingOut() = runTest {
        bus.changes.test {
            awaitItem()
            for (action in listOf(UsbManager.ACTION_USB_DEVICE_ATTACHED, UsbManager.ACTION_USB_DEVICE_DETACHED)) {
                context.sendBroadcast(Intent(action))
                ShadowLooper.idleMainLooper()
                awaitItem()
            }
            cancelAndIgnoreRemainingEvents()
        }
    }

    @Test fun aPortThatCannotBeSetUpIsClosedAgain() {
        shadowOf(manager).addOrUpdateUsbDevice(device, true)
        assertThrows(IOException::class.java) { bus.belt()!!.open() }
        assertTrue(port.closed)
    }
}
