#pragma once

#include <optional>

#include "echoway/units.hpp"

namespace echoway::tracker {

/// What a gyroscope reads while its wearer stands: its bias (a zero-rate update, as in pedestrian dead reckoning with
/// foot-mounted sensors: Foxlin 2005).
class StillRate {
 public:
  /// A reading, rad/s; `stepping` when steps were heard lately.
  void note(double time_s, double rate, bool stepping) noexcept;
  void reset() noexcept { count_ = 0; }
  /// Mean rate of a second in which nobody stepped or turned, once.
  [[nodiscard]] std::optional<double> take() noexcept;

  static constexpr double kSigma = degrees(0.3);   ///< rad/s, of that mean: people at rest still turn a little.

 private:
  double begin_ = 0.0;
  double last_ = 0.0;
  double sum_ = 0.0;
  int count_ = 0;
  std::optional<double> mean_;
};


}  // namespace echoway::tracker
