#include "guidance/outlook.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::guidance {
namespace {

/// From the chest's middle to where a wall is brushed, metres.
constexpr double kShoulder = 0.2;
/// Who is to walk on must not have a thing before them that no plan knows, of which only some points are known, metres.
constexpr double kFaceThing = 0.4;
/// How ill a turn is made.
constexpr double kWobble = degrees(8.0);
/// A position is taken to be off by so much at most, metres.
constexpr double kMostBlur = 0.2;
/// Places at most this far apart are looked at on the way to where a turn is made, metres.
constexpr double kStops = 0.3;

}  // namespace

Outlook::Approach Outlook::approach(const View& view, const Cue& cue, const Demand& demand) const noexcept {
  const Estimate& e = *view.estimate;
  Approach way;
  way.ahead = unit_from_angle(e.pose.heading);
  way.blur = demand.sigmas * std::min(e.sigma_m, kMostBlur);
  way.due = reaction_->way(cue, view.speed);
  way.latest = way.due + reaction_->spread_s() * view.speed + way.blur;
  way.until_wall = std::max(0.0, router_->space(e.room).reach(e.pose.position, way.ahead, 10.0) - config_->body_m);
  return way;
}

bool Outlook::clear_of_walls(const View& view, const Approach& way, double direction, const Demand& demand) const noexcept {
  const Pose2& pose = view.estimate->pose;
  const FreeSpace& space = router_->space(view.estimate->room);
  const double drift = direction == 0.0 ? 0.0 : std::sin(kWobble);  // who goes on anyhow is no worse off than they were
  // All the way there too: somebody who touches a wall meanwhile stands still and does it where they are.
  const int stops = 1 + static_cast<int>(std::ceil(way.latest / kStops));
  for (int i = 0; i <= stops; ++i) {
    const double on = std::min(way.latest * i / stops, way.until_wall);
    const Vec2 there = pose.position + on * way.ahead;
    const double play = way.blur + on * drift;
    for (const double side : {-1.0, 1.0}) {
      const Vec2 then = unit_from_angle(pose.heading + direction + side * kWobble);
      for (const double error : {-play, play}) {
        if (space.reach(there + error * perpendicular(then), then, demand.free_m) < demand.free_m) return false;
      }
    }
  }
  return true;
}

bool Outlook::clear_of_things(const View& view, const Approach& way, double direction, const Demand& demand) const noexcept {
  const Pose2& pose = view.estimate->pose;
  const double needed = std::min(demand.free_m, kFaceThing);
  const double play = way.latest - way.due;
  for (const double on : {way.due - play, way.due + play, 0.0}) {
    const Vec2 there = pose.position + std::min(on, way.until_wall) * way.ahead;
    for (const double side : {-1.0, 1.0}) {
      const Vec2 then = unit_from_angle(pose.heading + direction + side * kWobble);
      if (hindrances_->reach(view.estimate->room, view.now, there, then, needed) < needed) return false;
    }
  }
  return true;
}

bool Outlook::clear_ahead(const View& view, const Cue& cue, double direction, const Demand& demand) const noexcept {
  const Approach way = approach(view, cue, demand);
  return clear_of_walls(view, way, direction, demand) && clear_of_things(view, way, direction, demand);
}

bool Outlook::grazes(const View& view) const noexcept {
  const Pose2& pose = view.estimate->pose;
  const FreeSpace& space = router_->space(view.estimate->room);
  const double far = std::min(view.target_away, view.speed * config_->contradiction_gap_s);
  const Vec2 ahead = unit_from_angle(pose.heading);
  for (const double side : {-1.0, 1.0}) {
    const Vec2 shoulder = pose.position + side * kShoulder * perpendicular(ahead);
    // A bend away from the wall that is brushed, not towards it.
    if (side * view.off < 0.0 && space.reach(shoulder, ahead, far) < far) return true;
  }
  return false;
}

}  // namespace echoway::guidance
