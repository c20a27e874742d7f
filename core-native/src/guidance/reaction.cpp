#include "guidance/reaction.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"
#include "guidance/announcer.hpp"

namespace echoway::guidance {

double Reaction::spread_s() const noexcept {
  constexpr double kStranger = 0.35;
  constexpr double kAcquaintance = 0.15;
  return learnt_ < 2 ? kStranger : kAcquaintance;
}

double Reaction::way(const Cue& cue, double speed) const noexcept {
  return speed * (spoken_seconds(cue, *config_) + seconds_);
}

void Reaction::time(const Cue& cue, double heading, double now) noexcept {
  const double direction = cue.tail.present ? cue.tail.direction : cue.direction;
  if (std::abs(direction) < degrees(45.0) || (cue.tail.present && cue.tail.kind != CueKind::turn)) return;
  told_until_ = now + spoken_seconds(cue, *config_);
  told_from_ = heading;
  told_left_ = direction > 0.0;
}

void Reaction::watch(const Estimate& e) noexcept {
  if (told_until_ < 0.0) return;
  constexpr double kSeen = degrees(25.0);    // turned by this much, the turn has begun
  constexpr double kSeenAfter = 0.28;        // which takes this long, s
  constexpr double kTooLong = 3.0;           // it was not taken in
  constexpr int kTrust = 6;
  const double after = e.time_s - told_until_;
  const double turned = wrap_angle(e.pose.heading - told_from_);
  if (after > kTooLong) told_until_ = -1.0;
  if ((told_left_ ? turned : -turned) < kSeen) return;
  told_until_ = -1.0;
  learnt_ = std::min(learnt_ + 1, kTrust);
  seconds_ += (std::clamp(after - kSeenAfter, 0.2, 2.0) - seconds_) / (learnt_ + 1.0);
}

}  // namespace echoway::guidance
