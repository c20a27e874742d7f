#include "guidance/certainty.hpp"

#include <algorithm>
#include <utility>

namespace echoway::guidance {

bool Certainty::place_jumps(const Estimate& e) noexcept {
  constexpr double kNoStep = 0.8;    // from one firing to the next, metres
  constexpr double kFastest = 2.5;   // m/s
  const Estimate last = std::exchange(last_, e);
  if (last.room != e.room || e.room == kNoRoom) return false;
  const double apart = distance(last.pose.position, e.pose.position);
  return apart > kNoStep + kFastest * std::max(0.0, e.time_s - last.time_s);
}

void Certainty::update(const Estimate& e, bool suspended) noexcept {
  if (!started_) changing_since_ = e.time_s;
  started_ = true;
  const GuideConfig& c = *config_;
  const bool jumps = place_jumps(e);
  if (jumps) jumped_s_ = e.time_s;
  const bool fits = e.state == TrackState::tracking && e.room != kNoRoom;
  const bool bad = !fits || !(e.sigma_m <= c.lost_sigma_m) || !(e.room_probability >= c.lost_probability);
  fits_now_ = !bad;
  const bool good = fits && e.sigma_m <= c.found_sigma_m && e.room_probability >= c.found_probability;
  const bool lost = level_ == Level::lost;
  const bool change = lost ? good : bad && !suspended;
  if (!change || (lost && jumps)) changing_since_ = e.time_s;
  // Echoes that do not fit near what no plan knows are no loss yet while the place is narrow and goes on steadily.
  const bool steady = is_finite(e.pose) && e.room != kNoRoom && e.sigma_m <= c.vague_sigma_m &&
                      e.room_probability >= c.vague_probability && e.time_s - jumped_s_ > c.steady_lost_after_s;
  const double lost_after = steady ? c.steady_lost_after_s : c.lost_after_s;
  if (change && e.time_s - changing_since_ >= (lost ? doubt_ * c.found_after_s : lost_after)) {
    level_ = lost ? Level::sure : Level::lost;
    // A place that was lost again at once was none: the next one has to fit for longer.
    constexpr double kMostDoubt = 8.0;
    if (lost && was_sure_) found_at_ = e.time_s;
    if (!lost) doubt_ = e.time_s - found_at_ < c.relapse_s ? std::min(2.0 * doubt_, kMostDoubt) : 1.0;
    was_sure_ = was_sure_ || lost;
    changing_since_ = e.time_s;
  }
  if (level_ == Level::lost) return;
  const bool vague = bad || e.sigma_m > c.vague_sigma_m || e.room_probability < c.vague_probability;
  level_ = vague ? Level::vague : Level::sure;
}

}  // namespace echoway::guidance
