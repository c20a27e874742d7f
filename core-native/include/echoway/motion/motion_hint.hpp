#pragma once

#include <cstdint>

namespace echoway {

enum class MotionKind : std::uint8_t {
  step,      ///< The phone's step detector saw a step; `value` is 1. May be missed, invented, or up to 0.3 s late.
  yaw_rate,  ///< Gyroscope about the vertical since its last reading, `value` in rad/s, counter-clockwise. Biased.
  heading,   ///< Absolute heading, `value` in rad in the level's frame; drifts.
};

/// What the phone's own sensors say about the wearer's motion.
struct MotionHint {
  double time_s = 0.0;
  MotionKind kind = MotionKind::step;
  double value = 0.0;
};

}  // namespace echoway
