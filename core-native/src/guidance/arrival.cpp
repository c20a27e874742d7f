#include "guidance/arrival.hpp"

#include <algorithm>
#include <cmath>

#include "guidance/surroundings.hpp"

namespace echoway::guidance {
namespace {

/// A pace that was seen counts for less from look to look: who slows down for good walks at another.
constexpr double kFades = 0.97;

}  // namespace

void Arrival::note_room(const Estimate& e) noexcept {
  if (e.room != room_) room_since_ = e.time_s;
  room_ = e.room;
}

Arrival::After Arrival::after(const View& view) noexcept {
  if (told_at_ < 0.0) return After::not_told;
  constexpr double kSettle = 4.0;
  if (view.now - told_at_ < kSettle) return After::settling;
  const bool there = view.remaining < 1.5 * config_->arrive_m;
  if (there && !view.walking && !view.vague) return After::done;
  if (there || (view.walking && view.remaining < 2.0 * config_->arrive_m)) return After::settling;
  told_at_ = -1.0;
  return After::walked_on;
}

/// Before a doorway the room flickers: who is to go just inside is not there yet. And who is told that they are there
/// asks no further.
bool Arrival::is_place_sharp(const View& view) const noexcept {
  constexpr double kSureOfRoom = 0.85;
  constexpr double kInRoom = 1.0;  // s
  const Estimate& e = *view.estimate;
  return e.sigma_m <= config_->found_sigma_m && e.room_probability >= kSureOfRoom && view.now - room_since_ >= kInRoom;
}

/// Near things that no plan knows the echoes never fit: the place must hold for longer then.
bool Arrival::is_place_known(const View& view) const noexcept {
  constexpr double kHolds = 5.0;  // s
  const bool fits = view.estimate->state == TrackState::tracking;
  return is_place_sharp(view) && (fits || view.now - there_since_ >= kHolds);
}

bool Arrival::is_there(const View& view, bool holding) const {
  const Estimate& e = *view.estimate;
  const Vec2 goal = way_->route().waypoints.back().at;
  // Its first word is enough to stop at.
  const double lead = reaction_->way(make_cue(CueKind::stop), view.speed);
  // Said early only to somebody who walks straight up to it, from a place that is well known.
  constexpr double kWellKnown = 0.3;  // m
  const bool approaching =
      view.walking && e.sigma_m <= kWellKnown && !holding && std::abs(view.off) <= config_->ahead_rad;
  const double near = approaching ? std::clamp(lead, config_->arrive_m, 1.6 * config_->arrive_m) : config_->arrive_m;
  if (view.remaining <= near) return true;
  return distance(goal, e.pose.position) <= near && router_->space(e.room).clear_between(e.pose.position, goal, 0.1);
}

Cue Arrival::cue_for(const Pose2& pose) const {
  Cue cue = make_cue(CueKind::arrived);
  cue.landmark = landmark_of(way_->route().goal);
  const auto point_at = [&](const std::vector<Landmark>& all) {
    const Vec2 at = all[static_cast<std::size_t>(cue.landmark.index)].at;
    cue.has_direction = distance(at, pose.position) > 0.3;
    cue.direction = direction_to(pose, at);
  };
  if (cue.landmark.kind == CueLandmark::Kind::place) point_at(router_->building().places);
  if (cue.landmark.kind == CueLandmark::Kind::exit) point_at(router_->building().exits);
  return cue;
}

/// Whether a walker is too vaguely known, or would stop too far beyond.
bool Arrival::walks_past(const View& view) const {
  constexpr double kKnown = 0.4;   // metres
  constexpr double kBeyond = 1.2;  // metres
  if (!view.walking) return false;
  const Estimate& e = *view.estimate;
  const Vec2 ahead = unit_from_angle(e.pose.heading);
  const double stopping = reaction_->way(make_cue(CueKind::stop), view.speed);
  const double on = router_->space(e.room).reach(e.pose.position, ahead, stopping);
  return e.sigma_m > kKnown || distance(e.pose.position + on * ahead, way_->route().waypoints.back().at) > kBeyond;
}

/// A tracker has who stops, or walks into something, go on for a moment, and takes them back a second later.
bool Arrival::comes_to_a_stand(const View& view, bool holding) const noexcept {
  constexpr double kSlows = 0.75;   // share of the pace
  constexpr double kSettles = 1.0;  // s
  if (view.walking) return holding || view.speed < kSlows * pace_;
  return view.now - view.still_since < kSettles;
}

/// Whether the tracker has had the time to look for places as likely.
bool Arrival::has_stood_doubt(double now) const noexcept {
  constexpr double kLooks = 5.0;  // s
  return now - doubted_at_ >= kLooks;
}

Arrival::Now Arrival::tell(const View& view, bool holding, Announcer& voice) {
  pace_ = view.walking ? std::max(view.speed, kFades * pace_) : 0.0;
  const bool there = way_->route().waypoints.back().room == view.estimate->room && is_there(view, holding);
  there_since_ = there ? std::min(there_since_, view.now) : kNotThere;
  if (!there) return Now::elsewhere;
  if (told_at_ >= 0.0) return Now::there;
  if (!is_place_known(view)) return !view.walking && is_place_sharp(view) ? Now::there : Now::elsewhere;
  if (comes_to_a_stand(view, holding)) return Now::there;
  if (walks_past(view)) return Now::walks_past;
  // Who is told asks no further, and may be in another room that looks the same.
  if (view.unproven && view.walking) return Now::walks_past;
  if (view.unproven && doubted_at_ < 0.0) {
    doubted_at_ = view.now;
    return Now::doubtful;
  }
  if (view.unproven && !has_stood_doubt(view.now)) return Now::there;
  if (voice.offer(cue_for(view.estimate->pose), view.now)) told_at_ = view.now;
  return Now::there;
}

}  // namespace echoway::guidance
