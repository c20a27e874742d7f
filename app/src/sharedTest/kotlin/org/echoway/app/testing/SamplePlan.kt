package org.echoway.app.testing

import java.io.File
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.engine.Line
import org.echoway.app.engine.NavigationState
import org.echoway.core.BeltHealth
import org.echoway.core.BeltLink
import org.echoway.core.Door
import org.echoway.core.Estimate
import org.echoway.core.Frame
import org.echoway.core.Landmark
import org.echoway.core.Plan
import org.echoway.core.Point
import org.echoway.core.Room
import org.echoway.core.RoomName
import org.echoway.core.SensorHealth
import org.echoway.core.SensorState
import org.echoway.core.Spot
import org.echoway.core.TrackState
import org.echoway.core.Wall

/** Two rooms of 6 m by 4 m side by side, a door between them, a lectern in the second. */
object SamplePlan {
    private val corners = listOf(Point(0.0, 0.0), Point(6.0, 0.0), Point(6.0, 4.0), Point(0.0, 4.0))
    private val walls = corners.indices.map { Wall(corners[it], corners[(it + 1) % corners.size]) }

    val office = Room("1", "Office", RoomName("1", "Office"), 0, Frame(0.0, 0.0, 0.0), walls, listOf(corners))
    val seminar =
        Room("4", "Seminar room", RoomName("4", "Seminar room"), 0, Frame(6.0, 0.0, 0.0), walls, listOf(corners))

    val plan = Plan(
        name = "Sample",
        rooms = listOf(office, seminar),
        doors = listOf(Door(Spot(0, Point(6.0, 2.0)), Spot(1, Point(0.0, 2.0)), 0.9)),
        links = emptyList(),
        exits = listOf(Landmark(Spot(0, Point(0.0, 1.0)), "Main entrance")),
        places = listOf(Landmark(Spot(1, Point(5.0, 3.0)), "Lectern")),
    )

    val building = InstalledBuilding("sample", File("sample"), plan)

    fun estimate(
        room: Int,
        x: Double,
        y: Double,
        headingDegrees: Double = 0.0,
        state: TrackState = TrackState.TRACKING,
        sigmaM: Double = 0.1,
    ) = Estimate(
        timeS = 0.0, room = room, x = x, y = y, heading = Math.toRadians(headingDegrees),
        sigmaM = sigmaM, sigmaHeading = 0.1, roomProbability = 0.95, state = state,
        covarianceXx = sigmaM * sigmaM, covarianceXy = 0.0, covarianceYy = sigmaM * sigmaM / 4,
        speedMps = 0.0, soundSpeedScale = 1.0,
    )

    fun health(link: BeltLink = BeltLink.CONNECTED, batteryV: Double? = null, troubled: Set<Int> = emptySet()) =
        BeltHealth.NONE.copy(
            link = link,
            batteryV = batteryV,
            sensors = List(15) {
                SensorHealth(if (it in troubled) SensorState.SILENT else SensorState.GOOD, 10, 10, 0, 1.0, 0.0)
            },
        )

    fun running(timeS: Double, estimate: Estimate, belt: BeltHealth = health(), line: Line = Line.OPEN) =
        NavigationState.Running(building, timeS, line, belt, estimate)
}
