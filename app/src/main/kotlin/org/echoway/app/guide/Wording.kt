package org.echoway.app.guide

import android.content.res.Resources
import android.icu.text.RuleBasedNumberFormat
import java.util.Locale
import kotlin.math.roundToInt
import org.echoway.app.R
import org.echoway.core.Room

/** Turns messages into the words that are spoken, in the language of [resources]. */
class Wording(private val resources: Resources) {
    private val locale: Locale get() = resources.configuration.locales[0]
    private val spelling by lazy { RuleBasedNumberFormat(locale, RuleBasedNumberFormat.SPELLOUT) }

    fun words(message: Message): String = when (message) {
        is Message.RoomEntered -> room(message.room)
        is Message.DoorNear -> text(R.string.say_door_near, direction(message.seen.direction), distance(message.seen))
        is Message.PlaceNear -> text(R.string.say_place_near, message.name, direction(message.seen.direction), distance(message.seen))
        Message.Unsure -> text(R.string.say_unsure)
        is Message.FoundAgain -> foundAgain(message)
        Message.Searching -> text(R.string.say_searching)
        Message.BeltLost -> text(R.string.say_belt_lost)
        Message.BeltBack -> text(R.string.say_belt_back)
        Message.BeltNotAllowed -> text(R.string.say_belt_not_allowed)
        Message.RecordingOver -> text(R.string.say_recording_over)
        is Message.SensorBlocked -> text(R.string.say_sensor_blocked, side(message.side))
        is Message.SensorClear -> text(R.string.say_sensor_clear, side(message.side))
        is Message.SensorsBlocked -> plural(R.plurals.say_sensors_blocked, message.count)
        Message.BatteryLow -> text(R.string.say_battery_low)
        is Message.CannotStart -> text(R.string.say_cannot_start, message.reason)
        Message.NoVibration -> text(R.string.say_no_vibration)
        is Message.WhereAmI -> answer(message.answer)
    }

    /** "Room 2, corridor." */
    fun room(room: Room): String {
        val number = text(R.string.room_number, room.id)
        return if (room.name.isEmpty()) "$number." else text(R.string.say_room, number, room.name)
    }

    private fun foundAgain(message: Message.FoundAgain): String {
        val again = text(R.string.say_found_again, text(R.string.room_number, message.room.id))
        return listOfNotNull(again, message.door?.let { text(R.string.say_door, direction(it)) }).joinToString(" ")
    }

    private fun answer(answer: Answer): String = when (answer) {
        is Answer.Here -> listOfNotNull(
            room(answer.room),
            answer.facing?.let(::facing),
            answer.door?.takeIf { answer.facing != Facing.Door || it.direction != Direction.AHEAD }
                ?.let { text(R.string.say_door_near, direction(it.direction), distance(it)) },
            answer.place?.takeIf { (answer.facing as? Facing.Place)?.name != it.name }
                ?.let { text(R.string.say_place_near, it.name, direction(it.seen.direction), distance(it.seen)) },
        ).joinToString(" ")
        is Answer.Unsure -> listOfNotNull(
            text(R.string.say_unsure),
            answer.likely?.let { text(R.string.say_probably, text(R.string.room_number, it.id)) },
        ).joinToString(" ")
        is Answer.NoBelt -> listOfNotNull(
            text(R.string.say_belt_lost),
            answer.lastRoom?.let { text(R.string.say_last_in, text(R.string.room_number, it.id)) },
        ).joinToString(" ")
        Answer.NotRunning -> text(R.string.say_not_running)
    }

    private fun facing(facing: Facing) = when (facing) {
        Facing.Door -> text(R.string.say_facing_door)
        is Facing.Place -> text(R.string.say_facing_place, facing.name)
        is Facing.Wall -> text(R.string.say_facing_wall, distance(facing.distanceM, facing.sigmaM))
    }

    private fun direction(direction: Direction) = resources.getStringArray(R.array.directions)[direction.ordinal]

    private fun side(side: Side) = resources.getStringArray(R.array.sides)[side.ordinal]

    private fun distance(seen: Seen) = distance(seen.distanceM, seen.sigmaM)

    /** Never more precise than the estimate: 1 ft below 10 ft, 5 ft above, and vague when the position is. */
    private fun distance(metres: Double, sigmaM: Double): String {
        if (sigmaM > VAGUE_SIGMA_M) return text(R.string.distance_vague)
        val feet = metres / METRES_PER_FOOT
        val rounded = if (feet < FINE_BELOW_FT) feet.roundToInt() else (feet / COARSE_FT).roundToInt() * COARSE_FT.toInt()
        return resources.getQuantityString(R.plurals.distance_feet, rounded, spelling.format(rounded.toLong()))
    }

    private fun text(id: Int, vararg arguments: Any) = resources.getString(id, *arguments)

    private fun plural(id: Int, count: Int) = resources.getQuantityString(id, count, spelling.format(count.toLong()).replaceFirstChar { it.titlecase(locale) })

    private companion object {
        const val METRES_PER_FOOT = 0.3048
        const val FINE_BELOW_FT = 9.5
        const val COARSE_FT = 5.0
        const val VAGUE_SIGMA_M = 0.9
    }
}
