package org.echoway.app.guide

/** Sides of the belt, counter-clockwise from the front, as a wearer would call them. */
enum class Side {
    FRONT,
    FRONT_LEFT,
    LEFT,
    BACK_LEFT,
    BACK,
    BACK_RIGHT,
    RIGHT,
    FRONT_RIGHT,
    ;

    companion object {
        /** Of sensor [sensor] of [count]. */
        fun of(sensor: Int, count: Int): Side =
            entries[((sensor.toDouble() / count * entries.size) + 0.5).toInt() % entries.size]
    }
}
