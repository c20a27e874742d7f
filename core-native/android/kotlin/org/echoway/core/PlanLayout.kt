package org.echoway.core

import java.nio.ByteBuffer

/** Reads the plan that the core wrote; see `core-native/jni/layouts.hpp`. */
internal class PlanLayout(private val from: ByteBuffer) {
    fun read() = Plan(
        name = text(),
        rooms = list { room() },
        doors = list { Door(spot(), spot(), from.getDouble()) },
        links = list { LevelLink(LevelLinkKind.entries[from.getInt()], spot(), spot()) },
        exits = list { Landmark(spot(), text()) },
        places = list { Landmark(spot(), text()) },
    )

    private fun room() = Room(
        id = text(),
        name = text(),
        aloud = RoomName(text(), text()),
        level = from.getInt(),
        frame = Frame(from.getDouble(), from.getDouble(), from.getDouble()),
        walls = list { Wall(point(), point()) },
        boundary = list { list { point() } },
    )

    private fun spot() = Spot(from.getInt(), point())

    private fun point() = from.point()

    private fun <T> list(item: () -> T): List<T> = from.list { item() }

    private fun text() = from.text()
}
