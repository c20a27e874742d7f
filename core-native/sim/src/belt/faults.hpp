#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

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
  /// Changes those sensors; all where none is named.
  template <class Change>
  void each(const std::vector<int>& sensors, Change change) {
    if (sensors.empty()) std::for_each(sensors_.begin(), sensors_.end(), change);
    for (const int sensor : sensors) change(sensors_.at(static_cast<std::size_t>(sensor)));
  }

  std::array<State, kMaxSensors> sensors_{};
};

}  // namespace echoway::sim
