#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "echoway/belt/belt.hpp"
#include "echoway/geometry/pose2.hpp"
#include "echoway/sim/world.hpp"

namespace echoway::sim {

/// A place in a room's own frame; the room by its id.
struct Place {
  std::string room;
  Vec2 at{};
};

/// Walks to a place, through doors and round corners where need be.
struct GoTo {
  Place to;
};
struct Pause {
  double seconds = 0.0;
};
/// Turns on the spot by an angle, counter-clockwise, radians.
struct TurnBy {
  double angle = 0.0;
};
/// Is carried to another place, blindfold: no motion is sensed and no echo heard on the way.
struct Teleport {
  Place to;
  double heading = 0.0;  ///< In that room's frame, radians.
};
struct SetSpeed {
  double mps = 0.5;
};

using WalkStep = std::variant<GoTo, Pause, TurnBy, Teleport, SetSpeed>;

/// What the wearer does, and in what world.
struct Walk {
  std::uint64_t seed = 1;
  Place start;
  double start_heading = 0.0;  ///< In the start room's frame, radians.
  double speed_mps = 0.5;      ///< 1.65 ft/s.
  std::vector<WalkStep> steps;
  World world{};
  BeltConfig belt{};           ///< What the belt is, and what the log says of it.
};

}  // namespace echoway::sim
