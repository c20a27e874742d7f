package org.echoway.app.guide

import android.content.Context
import android.content.res.Resources
import android.icu.text.RuleBasedNumberFormat
import java.util.Locale
import org.echoway.app.R
import org.echoway.app.engine.NoStart
import org.echoway.app.settings.inLanguage
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Language
import org.echoway.core.Plan
import org.echoway.core.Room

/** Turns messages into the words that are spoken, in the language of [resources]. */
class Wording(private val resources: Resources) {
    private val locale: Locale get() = resources.configuration.locales[0]
    private val spelling by lazy { RuleBasedNumberFormat(locale, RuleBasedNumberFormat.SPELLOUT) }

    fun words(message: Message): String = when (message) {
        is Message.Told -> message.cue.words
        Message.BeltLost -> text(R.string.say_belt_lost)
        Message.WaitingForBelt -> text(R.string.state_waiting)
        Message.Stopped -> text(R.string.say_not_running)
        Message.BeltBack -> text(R.string.say_belt_back)
        Message.BeltNotAllowed -> text(R.string.say_belt_not_allowed)
        Message.BeltRefused -> text(R.string.say_belt_refused)
        is Message.BeltChanged ->
            resources.getQuantityString(
                R.plurals.say_belt_changed, message.sensors, spelling.format(message.sensors.toLong()),
            )
        Message.RecordedWalk -> text(R.string.say_recorded_walk)
        is Message.Interrupted ->
            message.goal?.let { text(R.string.say_interrupted_led, name(message.plan, it)) }
                ?: text(R.string.say_interrupted)
        Message.RecordingOver -> text(R.string.say_recording_over)
        is Message.SensorBlocked -> text(R.string.say_sensor_blocked, side(message.side))
        is Message.SensorClear -> text(R.string.say_sensor_clear, side(message.side))
        is Message.SensorsBlocked -> plural(R.plurals.say_sensors_blocked, message.count)
        is Message.RecordingStopped ->
            text(if (message.diskFull) R.string.say_phone_full else R.string.say_recording_stopped)
        Message.BatteryLow -> text(R.string.say_battery_low)
        is Message.CannotStart -> cannotStart(message.why)
        Message.NoVibration -> text(R.string.say_no_vibration)
        is Message.RoomDetail -> detail(message)
        is Message.Unanswerable -> noAnswer(message.why)
        is Message.Again -> message.words
        Message.NothingToRepeat -> text(R.string.say_nothing_to_repeat)
        is Message.Muted -> text(if (message.on) R.string.say_muted else R.string.say_unmuted)
        is Message.CannotLead -> text(message.why.words)
        Message.LeadingBack -> text(R.string.say_leading_back)
        Message.LeadingStopped -> text(R.string.say_leading_stopped)
        Message.WayBackLost -> text(R.string.say_way_back_lost)
        is Message.StartedAgain ->
            message.place?.let { text(R.string.say_started_again_at, name(message.plan, it)) }
                ?: text(R.string.say_started_again)
        is Message.CannotStandAt ->
            message.place?.let { text(R.string.say_cannot_stand_at, name(message.plan, it)) }
                ?: text(R.string.say_cannot_stand)
        Message.NotAPass -> text(R.string.not_a_pass)
        Message.WatchEnded -> text(R.string.watch_ended)
        Message.StillSoon -> text(R.string.still_soon)
        Message.StillAlarm -> text(R.string.still_alarm)
        Message.StillCancelled -> text(R.string.still_cancelled)
        is Message.Explanation -> message.words
    }

    /** "Cannot start. The floor plan is unusable." */
    fun cannotStart(why: NoStart): String = text(R.string.say_cannot_start, text(why.words))

    /** "Room 2, corridor." */
    fun room(room: Room): String = "${name(room)}."

    /** "Room 2, corridor" */
    fun name(room: Room): String {
        val short = shortName(room)
        val more = room.aloud.name
        return if (more.isEmpty() || more == short) short else text(R.string.room_named, short, more)
    }

    /** "Room 2"; "Hall" for a room that is called by its name alone. */
    fun shortName(room: Room): String =
        room.aloud.run { if (number.isEmpty()) name else text(R.string.room_number, number) }

    /** What a destination is called. */
    fun name(plan: Plan, destination: Destination): String = when (destination.kind) {
        DestinationKind.PLACE -> plan.places[destination.index].name
        DestinationKind.EXIT -> plan.exits[destination.index].name.ifEmpty { text(R.string.exit_unnamed) }
        DestinationKind.ROOM -> name(plan.rooms[destination.index])
        DestinationKind.NEAREST_EXIT, DestinationKind.SPOT -> text(R.string.way_out)
    }

    private fun detail(message: Message.RoomDetail): String = listOfNotNull(
        message.doors.takeIf { it > 0 }?.let { plural(R.plurals.say_doors, it) },
        message.places.takeIf { it.isNotEmpty() }?.joinToString(", ", postfix = "."),
    ).joinToString(" ")

    private fun noAnswer(why: NoAnswer): String = when (why) {
        is NoAnswer.NoBelt -> listOfNotNull(
            text(R.string.say_belt_lost),
            why.lastRoom?.let { text(R.string.say_last_in, shortName(it)) },
        ).joinToString(" ")
        NoAnswer.NotAllowed -> text(R.string.say_belt_not_allowed)
        NoAnswer.NotRunning -> text(R.string.say_not_running)
    }

    private val NoStart.words
        get() = when (this) {
            NoStart.NO_BUILDING -> R.string.state_no_building
            NoStart.BUILDING_UNUSABLE -> R.string.say_plan_unusable
            NoStart.RECORDING_UNREADABLE -> R.string.say_recording_unreadable
        }

    private val NoWay.words
        get() = when (this) {
            NoWay.NO_EXIT_KNOWN -> R.string.say_no_exit
            NoWay.NOTHING_WALKED_YET -> R.string.say_nothing_walked
            NoWay.NOT_REACHABLE -> R.string.say_not_reachable
            NoWay.NOT_RUNNING -> R.string.say_not_running
        }

    private fun side(side: Side) = resources.getStringArray(R.array.sides)[side.ordinal]

    private fun text(id: Int, vararg arguments: Any) = resources.getString(id, *arguments)

    private fun plural(id: Int, count: Int) = resources.getQuantityString(id, count, spelled(count))

    /** Numbers as words, for an engine reads digits in its own way; the line begins with it. */
    private fun spelled(count: Int) = spelling.format(count.toLong()).replaceFirstChar { it.titlecase(locale) }

    companion object {
        /** The words of a language, whatever the phone's is. */
        fun of(context: Context, language: Language) = Wording(context.inLanguage(language).resources)
    }
}
