#include "guidance/certainty.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "guidance/place_change.hpp"

namespace echoway::guidance {

/// In the level's frame.
double Certainty::heading_of(const Estimate& e) const noexcept {
  return e.pose.heading + router_->building().room(e.room).frame.heading;
}

/// What the wearer does from one firing to the next; more than they can do is a jump to another guess.
bool Certainty::follow(const Estimate& e) noexcept {
  constexpr double kNoStep = 0.8;             // metres
  constexpr double kFastest = 2.5;            // m/s
  constexpr double kWalks = 0.3;              // m/s; slower, an estimate only wavers
  const Estimate last = std::exchange(last_, e);
  if (!is_place(router_->building(), last) || !is_place(router_->building(), e)) return false;
  const double seconds = std::clamp(e.time_s - last.time_s, 0.0, 1.0);
  const double turn = wrap_angle(heading_of(e) - heading_of(last));
  const bool jumps = least_walk(*router_, last, e) > kNoStep + kFastest * seconds;
  if (jumps) {
    proof_ = 0.0;
    return true;
  }
  proof_ += std::abs(turn);
  turned_ += turn;
  if (e.speed_mps > kWalks) walked_ += e.speed_mps * seconds;
  return false;
}

/// Whether the wearer can have come here from where they were last known, by what they have walked and turned since.
bool Certainty::is_within_walk(const Estimate& e) const noexcept {
  constexpr double kSlack = 1.5;           // metres, for what either place may be off
  constexpr double kAstray = degrees(60.0);
  if (!is_place(router_->building(), home_) || !is_place(router_->building(), e)) return false;
  const double off = wrap_angle(heading_of(e) - heading_of(home_) - turned_);
  return least_walk(*router_, home_, e) <= kSlack + walked_ && std::abs(off) < kAstray;
}

/// True once the place has been for a moment where nobody can have walked to: the one before was wrong, or this one is.
bool Certainty::has_moved_away(const Estimate& e, bool suspended) noexcept {
  constexpr double kMoment = 0.6;  // s
  const bool away = level_ != Level::lost && !suspended && is_place(router_->building(), e) && !is_within_walk(e);
  if (!away) away_since_ = -1.0;
  else if (away_since_ < 0.0) away_since_ = e.time_s;
  return away && e.time_s - away_since_ >= kMoment;
}

void Certainty::set_home(const Estimate& e) noexcept {
  home_ = e;
  walked_ = turned_ = 0.0;
}

void Certainty::become(Level level, double now) noexcept {
  constexpr double kMostDoubt = 8.0;
  const bool found = level != Level::lost;
  // A place that was lost again at once was none: the next one has to fit for longer.
  if (found && was_sure_) found_at_ = now;
  if (!found) doubt_ = now - found_at_ < config_->relapse_s ? std::min(2.0 * doubt_, kMostDoubt) : 1.0;
  was_sure_ = was_sure_ || found;
  level_ = level;
  changing_since_ = now;
  away_since_ = -1.0;
  proof_ = 0.0;
}

void Certainty::reject(double now) noexcept {
  become(Level::lost, now);
  home_ = {};
}

/// Near things that no plan knows the echoes do not fit although the place is right. It is where they were last known.
bool Certainty::holds_though_unfit(const Estimate& e) const noexcept {
  return was_sure_ && e.state == TrackState::lost && is_narrow(e) && is_within_walk(e);
}

bool Certainty::is_narrow(const Estimate& e) const noexcept {
  const GuideConfig& c = *config_;
  return is_finite(e.pose) && e.room != kNoRoom && e.sigma_m <= c.vague_sigma_m &&
         e.room_probability >= c.vague_probability;
}

void Certainty::update(const Estimate& e, bool suspended) noexcept {
  constexpr double kProof = degrees(90.0);
  constexpr double kSettled = 5.0;  // s after a jump
  const GuideConfig& c = *config_;
  const bool fits = e.state == TrackState::tracking && e.room != kNoRoom;
  const bool good = (fits || holds_though_unfit(e)) && e.sigma_m <= c.found_sigma_m &&
                    e.room_probability >= c.found_probability;
  if (!started_) {
    changing_since_ = e.time_s;
    told_ = good && facing_told_;
    if (told_) set_home(e);
  }
  started_ = true;
  const bool jumps = follow(e);
  if (jumps) jumped_s_ = e.time_s;
  const bool bad = !fits || !(e.sigma_m <= c.lost_sigma_m) || !(e.room_probability >= c.lost_probability);
  fits_now_ = !bad;
  const bool lost = level_ == Level::lost;
  const bool change = lost ? good : bad && !suspended;
  if (!change || (lost && jumps)) changing_since_ = e.time_s;
  // Echoes that do not fit near what no plan knows are no loss yet while the place is narrow and goes on steadily.
  const bool steady = is_narrow(e) && e.time_s - jumped_s_ > kSettled;
  const double lost_after = steady ? c.steady_lost_after_s : c.lost_after_s;
  const bool long_enough = change && e.time_s - changing_since_ >= (lost ? doubt_ * c.found_after_s : lost_after);
  if (lost && long_enough && (is_within_walk(e) || proof_ >= kProof)) {
    become(Level::sure, e.time_s);
    found_in_ = e.room;
  } else if (!lost && (long_enough || has_moved_away(e, suspended))) {
    become(Level::lost, e.time_s);
  }
  if (level_ == Level::lost) return;
  const bool vague = bad || e.sigma_m > c.vague_sigma_m || e.room_probability < c.vague_probability;
  level_ = vague ? Level::vague : Level::sure;
  if (fits_now_ && away_since_ < 0.0) set_home(e);
}

}  // namespace echoway::guidance
