package org.echoway.app.guide

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.echoway.app.testing.SamplePlan
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith

/** The exact words, by situation. */
@RunWith(AndroidJUnit4::class)
class WordingTest {
    private val wording = Wording(ApplicationProvider.getApplicationContext<Context>().resources)

    private fun feet(feet: Double) = feet * 0.3048

    private fun seen(direction: Direction, feet: Double, sigmaM: Double = 0.1) = Seen(direction, feet(feet), sigmaM)

    @Test fun situations() {
        val table = mapOf(
            Message.RoomEntered(SamplePlan.seminar) to "Room 4, Seminar room.",
            Message.RoomEntered(SamplePlan.seminar.copy(name = "")) to "Room 4.",
            Message.DoorNear(seen(Direction.RIGHT, 6.0)) to "Door right, six feet.",
            Message.DoorNear(seen(Direction.SLIGHTLY_LEFT, 1.2)) to "Door slightly left, one foot.",
            Message.DoorNear(seen(Direction.AHEAD, 13.0)) to "Door ahead, fifteen feet.",
            Message.DoorNear(seen(Direction.AHEAD, 9.8)) to "Door ahead, ten feet.",
            Message.DoorNear(seen(Direction.AHEAD, 6.0, sigmaM = 1.0)) to "Door ahead, a few steps.",
            Message.PlaceNear("Lectern", seen(Direction.BEHIND, 3.0)) to "Lectern behind you, three feet.",
            Message.Unsure to "Not sure where you are. Stop and turn slowly.",
            Message.FoundAgain(SamplePlan.office, Direction.LEFT) to "Room 1 again. Door left.",
            Message.FoundAgain(SamplePlan.office, null) to "Room 1 again.",
            Message.SensorBlocked(Side.FRONT_LEFT, 1) to "Front left sensor blocked.",
            Message.SensorsBlocked(4) to "Four sensors blocked.",
            Message.BeltLost to "Belt disconnected.",
            Message.BeltBack to "Belt connected.",
            Message.BatteryLow to "Belt battery low.",
        )
        table.forEach { (message, words) -> assertEquals(words, wording.words(message)) }
        table.keys.filter { it.rank >= Rank.PLACE }.forEach { assertTrue(wording.words(it).split(' ').size <= 8) }
    }

    @Test fun whereAmI() {
        val here = Answer.Here(SamplePlan.seminar, Facing.Wall(feet(12.0), 0.1), seen(Direction.BEHIND, 8.0), null)
        assertEquals("Room 4, Seminar room. Facing a wall, ten feet. Door behind you, eight feet.", wording.words(Message.WhereAmI(here)))
        val atDoor = Answer.Here(SamplePlan.office, Facing.Door, seen(Direction.AHEAD, 3.0), null)
        assertEquals("Room 1, Office. Facing a door.", wording.words(Message.WhereAmI(atDoor)))
        assertEquals("Belt disconnected. You were in Room 1.", wording.words(Message.WhereAmI(Answer.NoBelt(SamplePlan.office))))
    }
}
