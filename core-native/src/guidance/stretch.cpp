#include "guidance/stretch.hpp"

namespace echoway::guidance {

void Stretch::tell(const View& view, double length_m) noexcept {
  length_m_ = length_m;
  from_ = {view.estimate->room, view.estimate->pose.position};
  begun_ = view.walking;
}

Stretch::Outcome Stretch::watch(const View& view, double acted_by) noexcept {
  constexpr double kStands = 1.5;    // s
  constexpr double kSetsOff = 3.0;   // s after the line and the reaction to it
  constexpr double kShort = 0.7;     // share of what was told
  constexpr double kMuch = 0.6;      // metres left
  constexpr double kNothing = 0.15;  // metres gone
  constexpr int kTold = 2;
  if (view.walking) stood_ = 0;  // whatever else they were told: nothing holds them
  if (length_m_ < 0.0) return Outcome::open;
  if (from_.room != view.estimate->room) {
    length_m_ = -1.0;
    stood_ = 0;
    return Outcome::open;
  }
  if (view.walking) begun_ = true;
  const bool stands = !view.walking && view.now - view.still_since >= kStands;
  const bool waits = stands && !begun_ && view.now > acted_by + kSetsOff;
  const double gone = distance(view.estimate->pose.position, from_.at);
  const bool well_short = gone < kShort * length_m_ && (length_m_ - gone > kMuch || gone < kNothing);
  if (!waits && !(stands && begun_)) return well_short && begun_ && !view.walking ? Outcome::short_of : Outcome::open;
  stood_ = waits ? stood_ + 1 : 0;
  length_m_ = -1.0;
  if (well_short && (begun_ || stood_ >= kTold)) {
    stood_ = 0;
    return Outcome::met;
  }
  return waits ? Outcome::not_begun : Outcome::open;
}

}  // namespace echoway::guidance
