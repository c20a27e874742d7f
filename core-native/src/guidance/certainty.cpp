#include "guidance/certainty.hpp"

#include <algorithm>

namespace echoway::guidance {

void Certainty::update(const Estimate& e, bool suspended) noexcept {
  if (!started_) changing_since_ = e.time_s;
  started_ = true;
  const GuideConfig& c = *config_;
  const bool fits = e.state == TrackState::tracking && e.room != kNoRoom;
  const bool bad = !fits || !(e.sigma_m <= c.lost_sigma_m) || !(e.room_probability >= c.lost_probability);
  fits_now_ = !bad;
  const bool good = fits && e.sigma_m <= c.found_sigma_m && e.room_probability >= c.found_probability;
  const bool lost = level_ == Level::lost;
  const bool change = lost ? good : bad && !suspended;
  if (!change) changing_since_ = e.time_s;
  if (change && e.time_s - changing_since_ >= (lost ? doubt_ * c.found_after_s : c.lost_after_s)) {
    level_ = lost ? Level::sure : Level::lost;
    // A place that was lost again at once was none: the next one has to fit for longer.
    constexpr double kMostDoubt = 8.0;
    if (lost && was_sure_) found_at_ = e.time_s;
    if (!lost) doubt_ = e.time_s - found_at_ < c.relapse_s ? std::min(2.0 * doubt_, kMostDoubt) : 1.0;
    was_sure_ = was_sure_ || lost;
    changing_since_ = e.time_s;
  }
  if (level_ == Level::lost) return;
  const bool vague = e.sigma_m > c.vague_sigma_m || e.room_probability < c.vague_probability;
  level_ = vague ? Level::vague : Level::sure;
}

}  // namespace echoway::guidance
