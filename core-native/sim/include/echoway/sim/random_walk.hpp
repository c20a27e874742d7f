#pragma once

#include <cstdint>
#include <string>

#include "echoway/building/building.hpp"
#include "echoway/sim/walk.hpp"

namespace echoway::sim {

struct RandomWalkOptions {
  double duration_s = 100.0;          ///< About; a walk ends with the leg that reaches it.
  double speed_mps = 0.5;             ///< 1.65 ft/s.
  double pause_probability = 0.25;    ///< At each goal.
  double turn_probability = 0.3;      ///< At each goal, on the spot.
  double leave_probability = 0.6;     ///< That the next goal lies in another room.
  double teleport_probability = 0.0;  ///< At each goal: carried blindfold to a room of the same building.
  double cover_probability = 0.0;     ///< At each goal: all sensors covered for half a minute to a minute.
  std::string start_room{};           ///< Empty: any.
  Profile profile = Profile::furnished;
  bool random_world = true;  ///< Draw the nuisance parameters too; else the profile's own.
};

/// A plausible walk: from goal to goal through doors, with pauses and turns on the spot. The same arguments give the
/// same walk. One that goes nowhere when the building has no rooms, or one that simulate() refuses as too large.
[[nodiscard]] Walk random_walk(const Building& building, const RandomWalkOptions& options, std::uint64_t seed);

}  // namespace echoway::sim
