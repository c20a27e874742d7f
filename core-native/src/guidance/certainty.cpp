#include "guidance/certainty.hpp"

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
  if (change && e.time_s - changing_since_ >= (lost ? c.found_after_s : c.lost_after_s)) {
    level_ = lost ? Level::sure : Level::lost;
    was_sure_ = was_sure_ || lost;
    changing_since_ = e.time_s;
  }
  if (level_ == Level::lost) return;
  const bool vague = e.sigma_m > c.vague_sigma_m || e.room_probability < c.vague_probability;
  level_ = vague ? Level::vague : Level::sure;
}

}  // namespace echoway::guidance
