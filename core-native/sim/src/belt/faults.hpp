#pragma once

#include <array>
#include <optional>

#include "echoway/sim/walk.hpp"

namespace echoway::sim {

/// What has happened to the belt's sensors so far.
class SensorFaults {
 public:
  void cover(const Cover& cover, double now_s);
  void set(const SensorFault& fault);

  /// What the sensor says instead of `range`.
  [[nodiscard]] std::optional<double> apply(int sensor, double now_s, std::optional<double> range) const;

 private:
  struct State {
    SensorFault::Kind fault = SensorFault::Kind::mended;
    double stuck_at_m = 0.0;
    double covered_until_s = -1.0;
  };
  std::array<State, kMaxSensors> sensors_{};
};

}  // namespace echoway::sim
