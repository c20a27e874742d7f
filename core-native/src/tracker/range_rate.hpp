#pragma once

#include <optional>

#include "echoway/geometry/vec2.hpp"
#include "tracker/echo_pairs.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// How fast the wearer walks, by the range rate of whatever stands ahead or behind.
struct SpeedReading {
  double speed = 0.0;       ///< m/s, along the heading.
  double variance = 0.0;    ///< (m/s)^2, above 0.
};

/// What the range rate of a pair tells of who walks at about `pace` m/s; nothing if it came from beside the wearer,
/// from an arm, or changed as it does for nobody who walks. `bearing`: cos, sin of the sensor's direction on the belt.
/// What stands in no plan says nothing of the place, but of the speed as much as any wall.
[[nodiscard]] std::optional<SpeedReading> speed_by_range_rate(const EchoPair& pair, Vec2 bearing, double pace) noexcept;

/// A walking particle's Gaussian is updated with `share`, above 0 and at most 1, of a reading's evidence, unless that
/// lies beyond a gate: then something else has answered. Returns the factor for its weight, which tells walkers of the
/// right speed from others, and from those who stand, for whom one speed is as likely as another: 0.6 to 1.7.
[[nodiscard]] double heed(Particle& particle, const SpeedReading& reading, double share) noexcept;

}  // namespace echoway::tracker
