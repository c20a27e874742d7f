#pragma once

#include <vector>

#include "echoway/building/building.hpp"

namespace echoway {

/// Doors whose two positions differ by less than this on the level do not count as a loop that fails to close, metres.
inline constexpr double kClosesWell = 1e-3;

/// Places every room in its level's frame and fills Building::loop_closures. Rooms with `has_frame` keep their frame;
/// the others are chained to them door by door, breadth first and by translation, which keeps the rotation of the room
/// that they are chained to. A level without any framed room starts at its first room. Returns, by room, the piece of
/// its level that the room belongs to: rooms of one piece have a known place with respect to each other. REQUIRES:
/// has_frame.size() == building.rooms.size().
std::vector<int> place_rooms(Building& building, const std::vector<bool>& has_frame);

}  // namespace echoway
