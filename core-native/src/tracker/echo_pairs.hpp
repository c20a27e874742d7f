#pragma once

#include <array>
#include <optional>

#include "echoway/belt/belt.hpp"

namespace echoway::tracker {

/// Two echoes of a sensor, 1.5 s apart at most, a pass of the belt as a rule, between which it has not turned away.
struct EchoPair {
  double seconds = 0.0;     ///< From one to the other, above 0.
  double before = 0.0;      ///< Range of the first,
  double range = 0.0;       ///< and of the second, metres.
};

/// Keeps every sensor's last echo. Whatever it was that answered twice, in a plan or in none, tells how the wearer
/// moved meanwhile.
class EchoPairs {
 public:
  /// The wearer turned by `turn` radians, as far as a gyroscope tells.
  void turn(double turn) noexcept { turned_ += turn; }

  /// What `sensor` (0 ... kMaxSensors - 1) hears at `time_s` seconds, `range` metres away, with its last echo; nothing
  /// if that was too long ago, or the sensor looks elsewhere now.
  [[nodiscard]] std::optional<EchoPair> hear(int sensor, double range, double time_s) noexcept;

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
