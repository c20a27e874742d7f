package org.echoway.app.belt

import app.cash.turbine.test
import java.io.IOException
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableSharedFlow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.merge
import kotlinx.coroutines.flow.receiveAsFlow
import kotlinx.coroutines.test.runTest
import org.echoway.app.testing.VirtualClock
import org.junit.Assert.assertArrayEquals
import org.junit.Assert.assertEquals
import org.junit.Test

class UsbBeltSourceTest {
    /** A port into which the test plugs belts. */
    private class Port : UsbBus {
        private val plugged = MutableStateFlow(0 to null as Plug?)
        private val refusals = MutableSharedFlow<UsbChange>(extraBufferCapacity = 1)
        override val changes: Flow<UsbChange> = merge(plugged.map { UsbChange.LOOK }, refusals)

        fun refuse() = refusals.tryEmit(UsbChange.REFUSED)

        override fun belt() = plugged.value.second

        fun plug(belt: Plug?) {
            plugged.value = plugged.value.first + 1 to belt
        }
    }

    private class Plug(override val id: String, override var permitted: Boolean) : UsbBelt {
        var asked = 0
        val bytes = Channel<ByteArray>(Channel.UNLIMITED)
        var closed = false

        override fun requestPermission() {
            asked++
        }

        override fun open() = object : SerialLine {
            override val bytes: Flow<ByteArray> = this@Plug.bytes.receiveAsFlow()

            override fun close() {
                closed = true
            }
        }
    }

    private val port = Port()

    @Test fun startsWhenTheBeltIsPluggedInAndAgainAfterItWasPulledOut() = runTest {
        UsbBeltSource(port, VirtualClock(testScheduler)).events.test {
            expectNoEvents()
            val first = Plug("a", permitted = true)
            port.plug(first)
            assertEquals(BeltEvent.Attached, awaitItem())
            first.bytes.send(byteArrayOf(1, 2))
            assertArrayEquals(byteArrayOf(1, 2), (awaitItem() as BeltEvent.Bytes).data)

            port.plug(null)
            first.bytes.close(IOException("gone"))
            assertEquals(BeltEvent.Detached, awaitItem())
            assertEquals(true, first.closed)

            port.plug(Plug("b", permitted = true))
            assertEquals(BeltEvent.Attached, awaitItem())
            cancelAndIgnoreRemainingEvents()
        }
    }

    @Test fun asksOnceForPermissionAndTakesItWhenGiven() = runTest {
        UsbBeltSource(port, VirtualClock(testScheduler)).events.test {
            val belt = Plug("a", permitted = false)
            port.plug(belt)
            assertEquals(BeltEvent.PermissionMissing, awaitItem())
            port.plug(belt) // something else changed on the port
            expectNoEvents()
            assertEquals(1, belt.asked)
            belt.permitted = true
            port.plug(belt)
            assertEquals(BeltEvent.Attached, awaitItem())
            cancelAndIgnoreRemainingEvents()
        }
    }

    @Test fun asksAgainOnlyAfterTheBeltWasPluggedInAnew() = runTest {
        UsbBeltSource(port, VirtualClock(testScheduler)).events.test {
            port.plug(Plug("a", permitted = false))
            assertEquals(BeltEvent.PermissionMissing, awaitItem())
            port.plug(null)
            assertEquals(BeltEvent.Detached, awaitItem())
            val again = Plug("b", permitted = false)
            port.plug(again)
            assertEquals(BeltEvent.PermissionMissing, awaitItem())
            assertEquals(1, again.asked)
            cancelAndIgnoreRemainingEvents()
        }
    }

    @Test fun whoRefusedByMistakeIsToldAndAskedAgainWhenTheyWishForIt() = runTest {
        val source = UsbBeltSource(port, VirtualClock(testScheduler))
        source.events.test {
            val belt = Plug("a", permitted = false)
            port.plug(belt)
            assertEquals(BeltEvent.PermissionMissing, awaitItem())
            port.refuse()
            assertEquals(BeltEvent.PermissionRefused, awaitItem())
            assertEquals(1, belt.asked)
            source.askAgain()
            assertEquals(BeltEvent.PermissionMissing, awaitItem())
            assertEquals(2, belt.asked)
            belt.permitted = true
            port.plug(belt)
            assertEquals(BeltEvent.Attached, awaitItem())
            cancelAndIgnoreRemainingEvents()
        }
    }

    @Test fun aLineThatCannotBeOpenedIsTriedAgain() = runTest {
        var tries = 0
        val belt = object : UsbBelt {
            override val id = "a"
            override val permitted = true

            override fun requestPermission() = Unit

            override fun open(): SerialLine {
                tries++
                throw IOException("busy")
            }
        }
        val bus = object : UsbBus {
            override val changes: Flow<UsbChange> = MutableStateFlow(UsbChange.LOOK)

            override fun belt() = belt
        }
        UsbBeltSource(bus, VirtualClock(testScheduler)).events.test {
            repeat(3) { assertEquals(BeltEvent.Detached, awaitItem()) }
            cancelAndIgnoreRemainingEvents()
        }
        assertEquals(3, tries.coerceAtMost(3))
    }
}
