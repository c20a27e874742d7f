#pragma once

#include <array>
#include <optional>

#include "echoway/belt/belt.hpp"
#include "echoway/units.hpp"

namespace echoway::guidance {

/// What the belt itself hears about the wearer, whatever place they are taken to be in: the newest echo of every
/// sensor. Directions are from the chest, radians; they hold for somebody who does not turn.
class HeardSpace {
 public:
  explicit HeardSpace(const BeltConfig& belt) : belt_(&belt) {}

  void on_firing(const Firing& firing) noexcept;
  void clear() noexcept { heard_.fill({}); }

  /// How far somebody can go to that side before what is heard in their way, metres. None where little is heard at all:
  /// a wall that is met aslant sends nothing back.
  [[nodiscard]] std::optional<double> way(double direction, double now) const noexcept;
  /// How far somebody who stands can go to that side before the nearest wall, if each steady echo came from one
  /// straight before its sensor, metres. None where none is heard.
  [[nodiscard]] std::optional<double> wall(double direction, double now) const noexcept;
  /// Distance of the nearest steady echo that comes from there, metres from the wearer's middle.
  [[nodiscard]] std::optional<double> toward(double direction, double now) const noexcept;
  /// Whether the nearest steady echo that comes from there is `free_m` away and more, and nothing nearer lies in the
  /// way. Where nothing answers it is not known: a wall too near to be heard says nothing either.
  [[nodiscard]] bool is_open(double direction, double free_m, double now) const noexcept;
  /// Whether any echo comes from there. A wall too near to be heard is silent, and so is one that is taken for the
  /// wearer's hands.
  [[nodiscard]] bool answers(double direction, double now) const noexcept;
  /// Distance of the nearest echo within a sensor's spacing of straight ahead, metres from the chest's middle.
  [[nodiscard]] std::optional<double> ahead(double now) const noexcept;

 private:
  struct Heard {
    double time_s = -1e300;
    double range_m = -1.0;  ///< From the wearer's middle; negative: no echo.
    double before_m = -1.0; ///< The same a pass before.
  };
  /// What a sensor hears, from the wearer's middle; none when nothing, or not any more.
  [[nodiscard]] std::optional<double> fresh(int sensor, double now) const noexcept;
  /// The same where it heard that a pass before too.
  [[nodiscard]] std::optional<double> steady(int sensor, double now) const noexcept;
  /// The least of what `listen(sensor, aside)` says of the sensors that look no more than `half` aside of `direction`
  /// (both in radians).
  template <class Listen>
  [[nodiscard]] std::optional<double> nearest(double direction, double half, Listen listen) const noexcept;

  /// How far aside of a direction a sensor looks that hears what comes from there, radians.
  [[nodiscard]] double around() const noexcept { return 0.75 * kTwoPi / belt_->sensors; }

  const BeltConfig* belt_;
  std::array<Heard, kMaxSensors> heard_{};
};

}  // namespace echoway::guidance
