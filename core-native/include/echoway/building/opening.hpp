#pragma once

#include <optional>
#include <vector>

#include "echoway/building/building.hpp"

namespace echoway {

/// A door farther than this from every wall of its room opens none of them, metres (3 ft).
inline constexpr double kDoorReach = feet(3.0);

/// Nobody passes a door narrower than this, metres (1.3 ft): `check` warns of it, and no way leads through it.
inline constexpr double kNarrowestDoor = feet(1.3);
[[nodiscard]] constexpr bool is_passable(const Door& door) noexcept { return door.width >= kNarrowestDoor; }

/// The stretch of a wall that a door opens, seen from one of the two rooms that the door joins.
struct DoorOpening {
  std::size_t door = 0;        ///< Index into Building::doors.
  RoomIndex beyond = kNoRoom;  ///< The room on the other side.
  std::size_t wall = 0;        ///< Index into Room::walls: the wall nearest to the door's centre.
  Segment span{};              ///< On that wall and in its direction, in the room's frame; never beyond its ends.
};

/// Openings of every room, by RoomIndex. A door's position may lie off the wall by half the wall's thickness: its foot
/// on the wall is the opening's centre. Doors off all walls, or of a width that is not positive, are left out.
[[nodiscard]] std::vector<std::vector<DoorOpening>> find_openings(const Building& building);

/// Where a door of `width` centred at `at` opens `room`; nothing when no wall is within kDoorReach.
[[nodiscard]] std::optional<DoorOpening> find_opening(const Room& room, Vec2 at, double width);

/// What is left of the walls of `room` when its doors stand open: pieces in the order of Room::walls. Cuts every wall
/// that runs along an opening, so that walls drawn twice or in pieces open as well.
[[nodiscard]] std::vector<Segment> walls_with_doors_open(const Room& room, const std::vector<DoorOpening>& openings);

}  // namespace echoway
