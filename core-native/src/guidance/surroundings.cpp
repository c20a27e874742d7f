#include "guidance/surroundings.hpp"

#include <cmath>

namespace echoway::guidance {
namespace {

constexpr double kFacing = degrees(20.0);

}  // namespace

double direction_to(const Pose2& pose, Vec2 at) noexcept {
  const Vec2 d = at - pose.position;
  return wrap_angle(std::atan2(d.y, d.x) - pose.heading);
}

Cue room_cue(CueKind kind, RoomIndex room) noexcept {
  Cue cue = make_cue(kind);
  cue.room = room;
  return cue;
}

Cue nearest_door(const Router& router, const Estimate& e) {
  Cue cue = make_cue(CueKind::door);
  cue.sigma_m = e.sigma_m;
  for (const Passage& p : router.space(e.room).passages()) {
    const double away = distance(p.centre, e.pose.position);
    if (cue.distance_m >= 0.0 && away >= cue.distance_m) continue;
    cue.distance_m = away;
    cue.direction = direction_to(e.pose, p.centre);
    cue.has_direction = true;
    cue.landmark = {CueLandmark::Kind::door, p.door};
  }
  return cue;
}

Cue nearest_passage(const Router& router, const Estimate& e) {
  const Building& b = router.building();
  Cue cue = nearest_door(router, e);
  const auto look_at = [&](CueKind kind, CueLandmark::Kind landmark, std::size_t index, RoomIndex room, Vec2 at) {
    const double away = distance(at, e.pose.position);
    if (room != e.room || (cue.distance_m >= 0.0 && away >= cue.distance_m)) return;
    cue = make_cue(kind);
    cue.sigma_m = e.sigma_m;
    cue.distance_m = away;
    cue.direction = direction_to(e.pose, at);
    cue.has_direction = true;
    cue.landmark = {landmark, static_cast<std::int32_t>(index)};
  };
  for (std::size_t i = 0; i < b.exits.size(); ++i) {
    look_at(CueKind::exit, CueLandmark::Kind::exit, i, b.exits[i].room, b.exits[i].at);
  }
  for (std::size_t i = 0; i < b.links.size(); ++i) {
    const LevelLink& link = b.links[i];
    const CueKind kind = link.kind == LevelLinkKind::stairs ? CueKind::stairs : CueKind::elevator;
    look_at(kind, CueLandmark::Kind::link, i, link.room_a, link.at_a);
    look_at(kind, CueLandmark::Kind::link, i, link.room_b, link.at_b);
    if (cue.landmark == CueLandmark{CueLandmark::Kind::link, static_cast<std::int32_t>(i)}) {
      const RoomIndex other = link.beyond(e.room);
      cue.up = b.room(other).level > b.room(e.room).level;
    }
  }
  return cue;
}

CueLandmark landmark_of(const Goal& goal) noexcept {
  switch (goal.kind) {
    case Goal::Kind::place:
      return {CueLandmark::Kind::place, goal.index};
    case Goal::Kind::exit:
      return {CueLandmark::Kind::exit, goal.index};
    case Goal::Kind::room:
      return {CueLandmark::Kind::room, goal.index};
    case Goal::Kind::nearest_exit:  // a route names the one that was chosen
    case Goal::Kind::spot:
      break;
  }
  return {};
}

Cue facing(const Router& router, const Estimate& e) {
  const Building& b = router.building();
  const FreeSpace& space = router.space(e.room);
  Cue cue = make_cue(CueKind::facing);
  cue.sigma_m = e.sigma_m;
  double nearest = 1e9;
  const auto look_at = [&](CueLandmark::Kind kind, std::size_t index, RoomIndex room, Vec2 at) {
    const double away = distance(at, e.pose.position);
    if (room != e.room || away >= nearest || away < 0.5 || std::abs(direction_to(e.pose, at)) > kFacing) return;
    const Vec2 unit = (1.0 / away) * (at - e.pose.position);
    if (space.reach(e.pose.position, unit, away) < away - 0.3) return;  // behind something
    nearest = away;
    cue.landmark = {kind, static_cast<std::int32_t>(index)};
  };
  for (std::size_t i = 0; i < b.places.size(); ++i) {
    look_at(CueLandmark::Kind::place, i, b.places[i].room, b.places[i].at);
  }
  for (std::size_t i = 0; i < b.exits.size(); ++i) {
    look_at(CueLandmark::Kind::exit, i, b.exits[i].room, b.exits[i].at);
  }
  for (std::size_t i = 0; i < b.links.size(); ++i) {
    look_at(CueLandmark::Kind::link, i, b.links[i].room_a, b.links[i].at_a);
    look_at(CueLandmark::Kind::link, i, b.links[i].room_b, b.links[i].at_b);
  }
  for (const Passage& p : space.passages()) {
    look_at(CueLandmark::Kind::door, static_cast<std::size_t>(p.door), e.room, p.centre);
  }
  if (cue.landmark.kind != CueLandmark::Kind::none) return cue;
  constexpr double kFurthest = 60.0;
  const double wall = space.reach(e.pose.position, unit_from_angle(e.pose.heading), kFurthest);
  if (wall < kFurthest) cue.distance_m = wall;
  return cue;
}

}  // namespace echoway::guidance
