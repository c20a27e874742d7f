#pragma once

#include <cmath>

#include "echoway/belt/belt.hpp"
#include "echoway/units.hpp"
#include "tracker/plans.hpp"

namespace echoway::test {

/// A hall that says nothing of the way along it but where it ends, and farther on cupboards that stand in no plan.
struct HallWithCupboards {
  static constexpr double kWidth = 2.4;   // Metres.
  double length = 40.0;
  double cupboards = 15.0;                // Metres from the hall's beginning,
  double answer = degrees(60.0);          // up to so far from the way ahead.
  BeltConfig belt{};

  Building plan() const {
    Building hall;
    hall.rooms.push_back(room_from_outline("hall", {{0, 0}, {length, 0}, {length, kWidth}, {0, kWidth}}));
    return hall;
  }

  /// What a sensor hears of a wearer who is `x` metres along the hall's middle and looks along it.
  double heard(int sensor, double x) const {
    const double bearing = wrap_angle(belt.bearing(sensor));
    if (std::abs(bearing) < answer) return (cupboards - x) / std::cos(bearing) - belt.radius_m;
    const bool beside = std::abs(std::abs(bearing) - 0.5 * kPi) < degrees(13.0);
    return beside ? 0.5 * kWidth - belt.radius_m : Firing::kNoEcho;
  }
};

}  // namespace echoway::test
