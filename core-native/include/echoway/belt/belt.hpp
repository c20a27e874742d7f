#pragma once

#include <cstdint>

#include "echoway/units.hpp"

namespace echoway {

/// The belt: n ranging sensors evenly spaced around the wearer, fired one after the other. Sensor i points to
/// `heading + i * 360/n` degrees (0 = front, counter-clockwise seen from above). Defaults: the thesis's prototype
/// (section 6.1) with a Polaroid 6500 ranging module.
struct BeltConfig {
  int sensors = 15;                       ///< 1 ... kMaxSensors.
  double radius_m = 0.15;                 ///< From the wearer's axis to the transducers' faces; ranges start there.
  double beam_rad = degrees(15.0);        ///< Full angle within which a plane wall answers.
  double slot_s = 0.0624;                 ///< Time between two firings: the two-way time of 35 ft (section 6.1).
  double min_range_m = feet(0.5);         ///< 6 in.
  double max_range_m = feet(35.0);
  double range_noise = 0.01;              ///< Standard deviation as a share of the range (1 %).
  /// Of the air in which its ranges are right: whose speed of sound it takes.
  double temperature_c = kReferenceCelsius;

  /// Direction of sensor `i` relative to the chest, radians in [0, 2 pi).
  [[nodiscard]] double bearing(int i) const noexcept { return kTwoPi * i / sensors; }
};

inline constexpr int kMaxSensors = 64;

/// One firing of one sensor.
struct Firing {
  double time_s = 0.0;
  int sensor = 0;
  double range_m = kNoEcho;               ///< From the transducer's face; kNoEcho when nothing answered.

  static constexpr double kNoEcho = -1.0;
  [[nodiscard]] bool has_echo() const noexcept { return range_m >= 0.0; }
};

}  // namespace echoway
