#pragma once

#include "tracker/placed.hpp"

namespace echoway::tracker {

/// Where steps and turns alone have led since the place was last known well. A belief that fits no longer
/// has lost its way among the echoes, or is held up by a wall that is not there; what was walked is known all
/// the same, to a fifth of the way.
class DeadReckoning {
 public:
  /// The place is known well: the count begins anew.
  void begin(const Placed& at) noexcept;
  /// Nothing is known any more: nobody counts steps on stairs, or turns without a gyroscope.
  void forget() noexcept { known_ = false; }
  /// A turn, radians, and a way ahead, metres.
  void move(double turn, double way) noexcept;

  [[nodiscard]] bool known() const noexcept { return known_; }
  /// In its level's frame. REQUIRES: known.
  [[nodiscard]] const Placed& at() const noexcept { return at_; }
  /// Log of how much likelier a place and heading are than if the wearer might be anywhere on `area`, square metres,
  /// facing anywhere. Never so low that echoes could not prove it wrong. REQUIRES: known.
  [[nodiscard]] double log_prior(const Placed& place, double area) const noexcept;

 private:
  Placed at_{};
  double way_ = 0.0;   ///< Walked since, metres.
  bool known_ = false;
};

}  // namespace echoway::tracker
