#pragma once

#include <vector>

#include "echoway/building/building.hpp"

namespace echoway::thesis {

/// A way out of a room into the next.
struct Exit {
  Vec2 at{};                ///< In the room's frame.
  RoomIndex to = kNoRoom;
  Pose2 into{};             ///< Takes this room's frame into the other's, by the door and both rooms' rotations.
};

/// The exits of every room: doors, stairs and elevators, each from both sides.
[[nodiscard]] std::vector<std::vector<Exit>> exits_of(const Building& building);

}  // namespace echoway::thesis
