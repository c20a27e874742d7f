package org.echoway.app.ui.map

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import org.echoway.app.testing.SamplePlan
import org.echoway.core.Point
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test

class MapCameraTest {
    /** The sample plan is 12 m by 4 m. */
    private val bounds = LevelDrawing.of(SamplePlan.plan, 0).bounds
    private val canvas = Size(1200f, 800f)
    private val wearer = WearerMark.of(SamplePlan.plan, SamplePlan.estimate(1, 4.0, 3.0, headingDegrees = 150.0))
    private val camera = MapCamera()

    private fun view(mark: WearerMark? = wearer) = camera.view(bounds, canvas, 0f, mark)

    private fun assertAt(expected: Offset, actual: Offset) {
        assertEquals(expected.x, actual.x, 0.5f)
        assertEquals(expected.y, actual.y, 0.5f)
    }

    @Test fun theWholeLevelFitsWithNorthUp() {
        assertAt(Offset(0f, 600f), view()(Point(0.0, 0.0)))
        assertAt(Offset(1200f, 200f), view()(Point(12.0, 4.0)))
    }

    @Test fun followingKeepsTheWearerInTheMiddleAndTheirHeadingUp() {
        camera.follow()
        camera.turnUp(true)
        val view = view()
        assertAt(Offset(600f, 400f), view(wearer.at))
        val ahead = Point(wearer.at.x + Math.cos(Math.toRadians(150.0)), wearer.at.y + Math.sin(Math.toRadians(150.0)))
        assertAt(Offset(600f, 400f - view.scale), view(ahead))
    }

    @Test fun theFingerKeepsHoldOfThePointBelowIt() {
        camera.turnUp(true)
        val before = view()
        val held = Point(3.0, 1.0)
        val finger = before(held)
        camera.gesture(before, Offset(70f, -40f), 1f)
        assertAt(finger + Offset(70f, -40f), view()(held))
        assertEquals(MapMode.FREE, camera.mode)
    }

    @Test fun zoomHasItsLimitsAndShowAllUndoesEverything() {
        repeat(50) { camera.zoomBy(2f) }
        assertEquals(100f * MapCamera.MOST_ZOOM, view().scale, 1f)
        repeat(50) { camera.zoomBy(0.5f) }
        assertEquals(100f, view().scale, 0.1f)
        camera.gesture(view(), Offset(10f, 0f), 3f)
        camera.showAll()
        assertAt(Offset(0f, 600f), view()(Point(0.0, 0.0)))
    }

    @Test fun withoutAWearerTheLevelIsNotTurned() {
        camera.turnUp(true)
        assertEquals(0.0, view(null).turn, 0.0)
    }

    @Test fun aTurnedLevelFitsWhateverTheHeading() {
        camera.turnUp(true)
        for (degrees in 0 until 360 step 15) {
            val view = view(
                WearerMark.of(SamplePlan.plan, SamplePlan.estimate(1, 4.0, 3.0, headingDegrees = degrees.toDouble())),
            )
            for (corner in listOf(Point(0.0, 0.0), Point(12.0, 0.0), Point(12.0, 4.0), Point(0.0, 4.0))) {
                val at = view(corner)
                assertTrue("$degrees: $at", at.x in -1f..1201f && at.y in -1f..801f)
            }
        }
    }
}
