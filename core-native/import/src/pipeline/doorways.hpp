#pragma once

#include <vector>

#include "pipeline/doors.hpp"

namespace echoway::import {

struct DoorSite {
  Vec2 at{};
  double width = 0.0;
};

/// Thins out the vertices of every room (no wall moves by more than 5 cm), then gives the depth of the wall in every
/// doorway to the smaller of its two rooms: its floor grows through the wall, with the reveal's sides as walls, up to
/// the face of the larger room. So the rooms meet in the doorway as they do in the building, the larger room (a
/// corridor, mostly) keeps a straight wall, and crossing a door takes the wearer from one floor straight to the next.
/// Returns each door's place on the common border, and how much of its width lies on one straight wall of both rooms.
/// `rooms` are indexed as the doors' cells.
[[nodiscard]] std::vector<DoorSite> open_doorways(std::vector<geos::Shape>& rooms,
                                                  const std::vector<PlacedDoor>& doors);

}  // namespace echoway::import
