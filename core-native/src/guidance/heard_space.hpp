#pragma once

#include <array>
#include <optional>

#include "echoway/belt/belt.hpp"

namespace echoway::guidance {

/// What the belt itself hears about the wearer, whatever place they are taken to be in: the newest echo of every sensor.
/// Directions are from the chest, radians; they hold for somebody who does not turn.
class HeardSpace {
 public:
  explicit HeardSpace(const BeltConfig& belt) : belt_(&belt) {}

  void on_firing(const Firing& firing) noexcept;
  void clear() noexcept { heard_.fill({}); }

  /// True when nothing is heard within `free_m` to that side, and enough is heard there at all: a wall that is met aslant
  /// sends nothing back.
  [[nodiscard]] bool is_free(double direction, double free_m, double now) const noexcept;
  /// Of ahead, left, right and behind the free one where the nearest echo is the farthest; `preferred` wins a draw.
  [[nodiscard]] std::optional<double> most_free(double free_m, double preferred, double now) const noexcept;
  /// Distance of the nearest echo within a sensor's spacing of straight ahead, metres from the chest's middle.
  [[nodiscard]] std::optional<double> ahead(double now) const noexcept;

 private:
  struct Heard {
    double time_s = -1e300;
    double range_m = -1.0;  ///< From the wearer's middle; negative: no echo.
  };
  [[nodiscard]] std::optional<double> nearest(double direction, double half_rad, int least, double now) const noexcept;

  const BeltConfig* belt_;
  std::array<Heard, kMaxSensors> heard_{};
};

}  // namespace echoway::guidance
