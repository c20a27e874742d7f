#pragma once

#include <array>
#include <span>

#include "echoway/locate/locator.hpp"

namespace echoway::tracker {

/// Says how far each reading may be believed before the map is asked.
class SensorHealth {
 public:
  explicit SensorHealth(int sensors) noexcept : sensors_(sensors) {}

  /// Notes a reading; returns the trust in it, 0 ... 1. A covered belt hears nothing from any sensor, which says nothing
  /// about the place: after a run of silence longer than rooms produce, silence stops being evidence.
  [[nodiscard]] double on_firing(int sensor, bool echo, double range) noexcept;

  [[nodiscard]] std::span<const SensorSuspicion> suspicions() const noexcept { return {suspicions_.data(), count_}; }

 private:
  int sensors_;
  int silent_run_ = 0;
  std::array<SensorSuspicion, kMaxSensors> suspicions_{};
  std::size_t count_ = 0;
};

}  // namespace echoway::tracker
