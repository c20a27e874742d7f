#pragma once

#include <array>

#include "echoway/belt/belt.hpp"

namespace echoway::tracker {

/// Who stands still hears the same from all sides a pass later, whatever it was that answered: in a plan, in none, by
/// several reflections. Who walks hears another range from nearly every side. So the belt tells by itself when its
/// wearer stops, as a boot's accelerometer does (zero-velocity updates, Foxlin 2005).
class Stillness {
 public:
  /// The wearer turned by `turn` radians, as far as a gyroscope tells.
  void turn(double turn) noexcept { turned_ += turn; }

  /// How many times as likely `sensor` (0 ... kMaxSensors - 1) hears `range` metres at `time_s` seconds from who has
  /// stood since its last echo as from who walks at `pace` m/s; 1 if that was too long ago, or the sensor looks
  /// elsewhere now. Positive, finite.
  [[nodiscard]] double hear(int sensor, double range, double time_s, double pace) noexcept;

 private:
  struct Last {
    double time_s = -1e300;
    double range = 0.0;
    double turned = 0.0;    ///< turned_ at that time.
  };
  std::array<Last, kMaxSensors> last_{};
  double turned_ = 0.0;     ///< Radians, since the beginning.
};

}  // namespace echoway::tracker
