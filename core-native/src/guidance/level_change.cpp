#include "guidance/level_change.hpp"

#include "echoway/geometry/pose2.hpp"
#include "guidance/surroundings.hpp"

namespace echoway::guidance {

void LevelChange::forget() noexcept {
  told_ = -1;
  suspended_until_ = -1e300;
  landing_ = kNoRoom;
}

Cue LevelChange::cue_for(CueKind kind, std::int32_t link, const View& view, Vec2 at) const noexcept {
  const Building& building = router_->building();
  const RoomIndex here = view.estimate->room;
  const RoomIndex there = building.links[static_cast<std::size_t>(link)].beyond(here);
  Cue cue = make_cue(kind);
  cue.landmark = {CueLandmark::Kind::link, link};
  cue.up = building.room(there).level > building.room(here).level;
  cue.direction = direction_to(view.estimate->pose, at);
  cue.has_direction = true;
  return cue;
}

bool LevelChange::tell(const View& view, const LinePoint& end, double along, Announcer& voice) {
  if (told_ == end.index) return false;
  const LevelLink& link = router_->building().links[static_cast<std::size_t>(end.index)];
  Cue cue = cue_for(link.kind == LevelLinkKind::stairs ? CueKind::stairs : CueKind::elevator, end.index, view, end.at);
  cue.distance_m = along;
  cue.sigma_m = view.estimate->sigma_m;
  if (!voice.offer(cue, view.now)) return false;
  told_ = end.index;
  return true;
}

bool LevelChange::take(const View& view, Announcer& voice) {
  const LinePoint& end = way_->line().back();
  if (end.kind != WaypointKind::link_from) return false;
  if (length_of(way_->line()) > config_->arrive_m + 0.5 * view.speed) return false;
  if (!voice.offer(cue_for(CueKind::take_link, end.index, view, end.at), view.now)) return true;
  const LevelLink& link = router_->building().links[static_cast<std::size_t>(end.index)];
  const double patience = config_->patience_s(link.kind);
  told_at_ = *view.estimate;
  asked_ = false;
  taken_ = end.index;
  landing_ = link.beyond(view.estimate->room);
  suspended_until_ = view.now + patience;
  transition_ = LevelTransition{static_cast<std::size_t>(end.index), view.estimate->room, landing_, view.now, patience};
  return true;
}

LevelChange::Asked LevelChange::ask(const Estimate& e) noexcept {
  constexpr double kThere = 1.5;    // metres
  constexpr double kRide = 15.0;    // s that the shortest takes about
  const bool there = e.state == TrackState::tracking && e.room == told_at_.room &&
                     distance(e.pose.position, told_at_.pose.position) < kThere;
  const bool first = !std::exchange(asked_, true);
  if (e.time_s - told_at_.time_s < kRide || (there && first)) return Asked::again;
  const bool out = !is_on_level_left(e);
  if (out) transition_ = over(e.time_s);
  forget();
  return out ? Asked::out : Asked::never;
}

LevelTransition LevelChange::over(double now) const noexcept {
  return {static_cast<std::size_t>(taken_), told_at_.room, landing_, now, 0.0};
}

bool LevelChange::is_on_level_left(const Estimate& e) const noexcept {
  const Building& building = router_->building();
  return building.has_room(e.room) && building.room(e.room).level == building.room(told_at_.room).level;
}

bool LevelChange::ends(const Estimate& e) noexcept {
  if (landing_ == kNoRoom || (e.room != landing_ && e.time_s < suspended_until_)) return false;
  if (e.room == landing_) transition_ = over(e.time_s);
  forget();
  return true;
}

}  // namespace echoway::guidance
