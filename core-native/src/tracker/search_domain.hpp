#pragma once

#include <optional>

#include "tracker/dead_reckoning.hpp"
#include "tracker/level_belief.hpp"

namespace echoway::tracker {

/// Where to look.
struct SearchDomain {
  RoomIndex only_room = kNoRoom;              ///< kNoRoom: everywhere.
  std::optional<double> heading;              ///< In that room's frame; unset: all round.
  std::optional<double> level_heading;        ///< In the levels' frames, when a compass said so; unset: all round.
  double heading_sigma = degrees(6.0);
  RoomIndex near_room = kNoRoom;              ///< When set, places near this one are likelier than elsewhere.
  Vec2 near_position{};                       ///< In that room's frame.
  std::optional<double> within;               ///< Metres: look no farther from there, on any level,
  std::optional<double> near_heading;         ///< and, when set, only about this heading (that room's frame).
  /// Log likelihood by which some place must do better in the sweep than the belief did; unset: there is none to beat.
  std::optional<double> least_gain;
  bool thorough = false;                      ///< Places that no echo tells apart shall all be found.
  const DeadReckoning* reckoning = nullptr;   ///< When set, and known, places near where it leads are likelier.
  const LevelBelief* levels = nullptr;        ///< When set, places on levels where the wearer has been are likelier.
};

}  // namespace echoway::tracker
