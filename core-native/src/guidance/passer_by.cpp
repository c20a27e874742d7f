#include "guidance/passer_by.hpp"

#include <algorithm>
#include <cmath>

#include "guidance/surroundings.hpp"

namespace echoway::guidance {
namespace {

constexpr double kWalks = 0.2;         // m/s
constexpr double kPassage = 1.8;       // metres: they are told from here
constexpr double kPlace = 2.0;
constexpr double kItsOwnDepth = 0.3;   // metres: a place may stand on a bench

bool is_in_sight(const FreeSpace& space, Vec2 from, Vec2 at) {
  const double away = distance(at, from);
  const Vec2 way = (1.0 / std::max(away, 1e-6)) * (at - from);
  return space.reach(from, way, away) >= away - kItsOwnDepth;
}

}  // namespace

void PasserBy::clear() noexcept {
  told_passage_ = {};
  std::fill(told_places_.begin(), told_places_.end(), false);
}

void PasserBy::tell(const Estimate& e, Announcer& voice) {
  if (e.speed_mps < kWalks) return;
  tell_passage(e, voice);
  for (std::size_t i = 0; i < told_places_.size(); ++i) tell_place(e, i, voice);
}

void PasserBy::tell_passage(const Estimate& e, Announcer& voice) {
  const Cue cue = nearest_passage(*router_, e);
  if (cue.distance_m > 2.0 * kPassage) told_passage_ = {};
  const bool near = cue.distance_m >= 0.3 && cue.distance_m <= kPassage && std::abs(cue.direction) <= degrees(110.0);
  if (!near || cue.landmark == told_passage_) return;
  if (voice.is_free(e.time_s) && voice.offer(cue, e.time_s)) told_passage_ = cue.landmark;
}

void PasserBy::tell_place(const Estimate& e, std::size_t i, Announcer& voice) {
  const Landmark& place = router_->building().places[i];
  const bool here = place.room == e.room;
  const double away = distance(place.at, e.pose.position);
  if (!here || away > 2.0 * kPlace) told_places_[i] = false;
  if (!here || away > kPlace || told_places_[i] || place.name.empty()) return;
  if (!is_in_sight(router_->space(e.room), e.pose.position, place.at)) return;
  Cue cue = make_cue(CueKind::place);
  cue.landmark = {CueLandmark::Kind::place, static_cast<std::int32_t>(i)};
  cue.direction = direction_to(e.pose, place.at);
  cue.has_direction = true;
  cue.distance_m = away;
  cue.sigma_m = e.sigma_m;
  if (voice.is_free(e.time_s) && voice.offer(cue, e.time_s)) told_places_[i] = true;
}

}  // namespace echoway::guidance
