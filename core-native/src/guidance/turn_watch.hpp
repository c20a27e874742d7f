#pragma once

#include <cmath>

#include "echoway/geometry/pose2.hpp"
#include "echoway/units.hpp"

namespace echoway::guidance {

/// Whether the wearer is turning. What is told to somebody who turns is done from where they face by then.
class TurnWatch {
 public:
  void update(double heading, double now) noexcept {
    constexpr double kNoTurn = degrees(20.0);  // from one estimate to the next: a jump to another guess
    const double turn = wrap_angle(heading - last_);
    last_ = heading;
    if (std::abs(turn) < kNoTurn) turned_ = wrap_angle(turned_ + turn);
    constexpr double kWindow = 0.5;           // s
    constexpr double kTurns = degrees(12.0);  // in that time; a walker veers by less, and so does an estimate
    const bool turns = now - since_ < 2.0 * kWindow && std::abs(wrap_angle(heading - heading_)) > kTurns;
    if (turns) {
      turning_ = true;  // known at once, not only when the window closes
      turned_s_ = now;
    }
    if (now - since_ < kWindow) return;
    turning_ = turns;
    heading_ = heading;
    since_ = now;
  }

  [[nodiscard]] bool turning() const noexcept { return turning_; }
  /// How far the wearer has turned since the beginning, radians in (-pi, pi]; right even while the place is not known.
  [[nodiscard]] double turned() const noexcept { return turned_; }
  /// True when nobody has turned for so long.
  [[nodiscard]] bool still_for(double seconds, double now) const noexcept { return now - turned_s_ > seconds; }

 private:
  double heading_ = 0.0;  ///< At
  double since_ = -1e300; ///< this time.
  double turned_s_ = -1e300;
  double last_ = 0.0;
  double turned_ = 0.0;
  bool turning_ = false;
};

}  // namespace echoway::guidance
