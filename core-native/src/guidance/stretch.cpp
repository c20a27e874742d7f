#include "guidance/stretch.hpp"

namespace echoway::guidance {

void Stretch::tell(const View& view, double length_m) noexcept {
  length_m_ = length_m;
  from_ = place_of(view);
  begun_ = view.walking;
  stopped_s_ = 1e300;
}

Stretch::OnLevel Stretch::place_of(const View& view) const noexcept {
  const Room& room = building_->room(view.estimate->room);
  return {room.level, room.frame.transform(view.estimate->pose.position)};
}

Stretch::Outcome Stretch::watch(const View& view, double acted_by) noexcept {
  constexpr double kStands = 1.5;    // s
  constexpr double kSetsOff = 3.0;   // s after the line and the reaction to it
  constexpr double kStops = 0.8;     // s after "Stop." begins at least
  constexpr double kShort = 0.7;     // share of what was told
  constexpr double kMuch = 0.6;      // metres left
  constexpr double kNothing = 0.15;  // metres gone
  constexpr int kTold = 2;
  if (view.walking) stood_ = 0;  // whatever else they were told: nothing holds them
  if (length_m_ < 0.0) return Outcome::open;
  const OnLevel here = place_of(view);
  const bool obeys = !view.walking && view.still_since > stopped_s_ + kStops;
  if (from_.level != here.level || obeys) {
    length_m_ = -1.0;
    stood_ = 0;
    return Outcome::open;
  }
  if (view.walking) begun_ = true;
  const bool stands = !view.walking && view.now - view.still_since >= kStands;
  const bool waits = stands && !begun_ && view.now > acted_by + kSetsOff;
  const double gone = distance(here.at, from_.at);
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
