package org.echoway.core

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A direct buffer that grows to what the core needs; used again and again, by one thread. */
internal class GrowingBuffer(bytes: Int) {
    private var buffer = newBuffer(bytes)

    /** [write] fills the buffer and returns the bytes that it takes, more than there are when it must be larger. */
    fun fill(write: (ByteBuffer) -> Int): ByteBuffer {
        buffer.clear()
        var size = write(buffer)
        if (size > buffer.capacity()) {
            buffer = newBuffer(size)
            size = write(buffer)
        }
        check(size <= buffer.capacity()) { "What the core writes changed while it was read." }
        return buffer
    }

    private fun newBuffer(bytes: Int) = ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder())
}

internal fun ByteBuffer.text(): String {
    val bytes = ByteArray(getInt())
    get(bytes)
    return String(bytes, Charsets.UTF_8)
}

internal fun ByteBuffer.point() = Point(getDouble(), getDouble())

internal fun ByteBuffer.flag() = getInt() != 0

internal fun <T> ByteBuffer.list(item: (ByteBuffer) -> T): List<T> = List(getInt()) { item(this) }
