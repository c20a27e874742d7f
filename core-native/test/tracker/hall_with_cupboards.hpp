#pragma once

#include <cmath>

#include "echoway/belt/belt.hpp"
#include "echoway/units.hpp"
#include "tracker/plans.hpp"

namespace echoway::test {

/// A long hall that says nothing of the way along it, and cupboards farther on that stand in no plan.
struct HallWithCupboards {
  static constexpr double kWidth = 2.4, kCupboards = 15.0;   // Metres.
  BeltConfig belt;
  Building plan;

  HallWithCupboards() {
    plan.rooms.push_back(room_from_outline("hall", {{0, 0}, {40, 0}, {40, kWidth}, {0, kWidth}}));
  }

  /// What a sensor hears of a wearer who is `x` metres along the hall's middle and looks along it.
  double heard(int sensor, double x) const {
    const double bearing = wrap_angle(belt.bearing(sensor));
    if (std::abs(bearing) < degrees(60.0)) return (kCupboards - x) / std::cos(bearing) - belt.radius_m;
    const bool beside = std::abs(std::abs(bearing) - 0.5 * kPi) < degrees(13.0);
    return beside ? 0.5 * kWidth - belt.radius_m : Firing::kNoEcho;
  }
};

}  // namespace echoway::test
