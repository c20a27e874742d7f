package org.echoway.app.control

import org.echoway.app.control.VolumeKey.DOWN
import org.echoway.app.control.VolumeKey.UP
import org.echoway.app.guide.Ask
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test

class VolumeChordsTest {
    private val asked = mutableListOf<Ask>()
    private val chords = VolumeChords { asked += it }
    private var now = 0L

    /** Both keys, [first] before the other, held for a while; the steps that the volume makes meanwhile. */
    private fun chord(first: VolumeKey, heldMs: Long): Int {
        val second = if (first == UP) DOWN else UP
        var steps = 0
        fun key(key: VolumeKey, pressed: Boolean) {
            if (!chords.onKey(key, pressed, now) && pressed) steps += if (key == UP) 1 else -1
        }
        key(first, true)
        now += 80
        key(second, true)
        for (repeat in 1..heldMs / 50) {
            now += 50
            key(second, true) // a held key repeats itself
        }
        key(first, false)
        key(second, false)
        now += 3_000
        return steps
    }

    @Test fun theOrderOfTheKeysTellsWhatIsAsked() {
        chord(UP, 150)
        chord(DOWN, 150)
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.REPEAT), asked)
    }

    @Test fun bothHeldForASecondAskTheWayOut() {
        chord(UP, 1_200)
        chord(DOWN, 1_200)
        assertEquals(listOf(Ask.WAY_OUT, Ask.WAY_OUT), asked)
    }

    @Test fun thePhonesOwnShortcutIsLeftAlone() {
        chord(UP, 3_200)
        assertEquals(emptyList<Ask>(), asked)
    }

    @Test fun bothTwiceMute() {
        chord(UP, 100)
        now -= 2_700
        chord(UP, 100)
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.MUTE), asked)
    }

    @Test fun aChordLeavesTheVolumeAsItWas() {
        assertEquals(0, chord(UP, 150))
        assertEquals(0, chord(DOWN, 1_500))
    }

    @Test fun oneKeyIsTheVolumes() {
        repeat(3) {
            assertFalse(chords.onKey(UP, true, now))
            now += 50
        }
        assertFalse(chords.onKey(UP, false, now))
        assertFalse(chords.onKey(DOWN, true, now + 500))
        assertFalse(chords.onKey(DOWN, false, now + 600))
        assertEquals(emptyList<Ask>(), asked)
    }

    private fun pressed(key: VolumeKey, heldMs: Long = 100) {
        assertTrue(chords.onKey(key, true, now))
        for (repeat in 1..heldMs / 50) {
            now += 50
            assertTrue(chords.onKey(key, true, now))
        }
        assertTrue(chords.onKey(key, false, now))
        now += 50
    }

    @Test fun whereLoneKeysAskEachAsksOnceAndTheVolumeStays() {
        chords.loneKeysAsk = true
        pressed(UP)
        pressed(DOWN, heldMs = 3_000)
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.WAY_BACK), asked)
    }

    @Test fun whereLoneKeysAskAChordIsStillOneQuestion() {
        chords.loneKeysAsk = true
        assertEquals(0, chord(UP, 150))
        chord(DOWN, 150)
        chord(UP, 1_200)
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.REPEAT, Ask.WAY_OUT), asked)
        pressed(DOWN)
        assertEquals(Ask.WAY_BACK, asked.last())
    }

    @Test fun withoutChordsTwoKeysTogetherAreOneQuestionAllTheSame() {
        chords.loneKeysAsk = true
        chords.chordsAsk = false
        chord(UP, 150)
        chord(DOWN, 1_200)
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.WAY_BACK), asked)
        chord(UP, 3_200)
        assertEquals("the phone's own shortcut", 2, asked.size)
    }

    @Test fun aKeyThatIsTakenBackAsksNothing() {
        chords.loneKeysAsk = true
        chords.onKey(DOWN, true, now)
        chords.onTakenBack(DOWN)
        chords.onKey(UP, true, now)
        chords.onKey(DOWN, true, now + 80)
        chords.onTakenBack(UP)
        chords.onTakenBack(DOWN)
        assertEquals(emptyList<Ask>(), asked)
        now += 1_000
        pressed(UP)
        assertEquals(listOf(Ask.WHERE_AM_I), asked)
    }

    @Test fun afterAChordOneKeyIsTheVolumesAgain() {
        chord(UP, 150)
        assertFalse(chords.onKey(DOWN, true, now))
        assertTrue(asked.size == 1)
    }
}
