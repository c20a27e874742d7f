#pragma once

#include <cstdint>

#include "echoway/building/building.hpp"
#include "echoway/geometry/pose2.hpp"

namespace echoway {

enum class TrackState : std::uint8_t {
  searching,  ///< Several places still explain the echoes.
  tracking,   ///< One place does, and it keeps doing so.
  lost,       ///< The echoes fit nowhere that the wearer could be.
};

/// Where the wearer is, as well as it is known.
struct Estimate {
  double time_s = 0.0;
  RoomIndex room = kNoRoom;
  Pose2 pose{};                     ///< In the room's frame.
  double sigma_m = 0.0;             ///< Standard deviation of the position along its worst direction, metres.
  double sigma_heading_rad = 0.0;
  double room_probability = 0.0;    ///< 0 ... 1.
  TrackState state = TrackState::searching;
  double covariance_xx = 0.0;       ///< Position covariance in the room's frame, square metres.
  double covariance_xy = 0.0;
  double covariance_yy = 0.0;
  double speed_mps = 0.0;           ///< Along the heading.
  double sound_speed_scale = 1.0;   ///< True speed of sound over the assumed one.
};

/// One of several places that explain the echoes; probabilities over all of a locator's hypotheses add up to at most 1.
struct Hypothesis {
  RoomIndex room = kNoRoom;
  Pose2 pose{};
  double sigma_m = 0.0;
  double probability = 0.0;
};

}  // namespace echoway
