#pragma once

#include <array>

#include "echoway/belt/belt.hpp"

namespace echoway::tracker {

/// How much of what a sensor says is new. Furniture, soft walls and people make a resting sensor repeat its error; only
/// one that has been moved or turned since it last fired tells something new.
class Novelty {
 public:
  /// The wearer went on by `metres` and turned by `radians` (absolute values).
  void move(double metres, double radians) noexcept {
    travelled_ += metres;
    turned_ += radians;
  }
  /// Share of the reading of `sensor`, which fires now, that is new: kLeast ... 1.
  [[nodiscard]] double of(int sensor) noexcept;
  /// Grows by one whenever a sensor sees something else.
  [[nodiscard]] double progress() const noexcept;

  static constexpr double kLeast = 0.20;

 private:
  struct Visit {
    bool made = false;
    double travelled = 0.0;
    double turned = 0.0;
  };
  std::array<Visit, kMaxSensors> visits_{};   ///< How far the wearer had come when each sensor last fired.
  double travelled_ = 0.0;
  double turned_ = 0.0;
};

}  // namespace echoway::tracker
