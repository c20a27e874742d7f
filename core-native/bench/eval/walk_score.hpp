#pragma once

#include <cstdint>

#include "echoway/building/building.hpp"
#include "echoway/sim/simulate.hpp"

namespace echoway::eval {

/// What the tracker is given of a walk.
struct Given {
  bool start = true;         ///< The pose that the walk begins with.
  bool hints = true;         ///< The phone's motion sensors.
  int particles = 0;         ///< 0: the tracker's own number.
  std::uint64_t seed = 1;    ///< Of the tracker's chance.
};

/// How well the tracker followed one walk, and what it cost: means over all firings.
struct WalkScore {
  int firings = 0;
  double error_m = 0.0;
  double heading_error_deg = 0.0;
  double right_room = 0.0;         ///< Share of firings,
  double within_2_sigma = 0.0;     ///< and of those where the error was within two of the sigma that was claimed.
  double sigma_m = 0.0;
  double found_s = -1.0;           ///< Seconds until the place was right for three seconds in a row; -1: never.
  double median_us = 0.0;          ///< Processor time of a firing.
  double mean_us = 0.0;
  double worst_us = 0.0;
};

[[nodiscard]] WalkScore score_walk(const Building& building, const sim::Simulation& walk, const Given& given);

}  // namespace echoway::eval
