#include "guidance/outlook.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "guidance/straight_walk.hpp"

namespace echoway::guidance {
namespace {

/// From the chest's middle to where a wall is brushed, metres.
constexpr double kShoulder = 0.2;
/// Who is to walk on must not have a thing before them that no plan knows, of which only some points are known, metres.
constexpr double kFaceThing = 0.4;
/// How ill a turn is made at least, and a heading known at worst.
constexpr double kWobble = degrees(8.0);
constexpr double kMostWobble = degrees(20.0);
/// The standard deviation of a position is taken to be this at most, metres.
constexpr double kMostBlur = 0.3;
/// Places at most this far apart are looked at on the way to where a turn is made, metres.
constexpr double kStops = 0.3;

/// Where a position that is off by one lies, about where it is taken to be: across the line of sight and along it.
struct Offset {
  double across;
  double along;
};
constexpr std::array<Offset, 5> kOffsets{{{-1.0, 0.0}, {-0.7, 0.7}, {0.0, 1.0}, {0.7, 0.7}, {1.0, 0.0}}};

/// Whether `needed` is free towards `then` from wherever within `blur` of `at`, and `drift` to a side, the wearer may
/// be.
bool is_free(const FreeSpace& space, Vec2 at, Vec2 then, double blur, double drift, double needed) noexcept {
  return std::all_of(kOffsets.begin(), kOffsets.end(), [&](const Offset& o) {
    const double far = needed + o.along * blur;
    return space.reach(at + o.across * (blur + drift) * perpendicular(then), then, far) >= far;
  });
}

/// Nobody stands in a wall or behind it, where a position that errs may be: the nearest place in the room then.
Pose2 in_room(const Router& router, const Estimate& e) noexcept {
  const FreeSpace& space = router.space(e.room);
  if (space.contains(e.pose.position)) return e.pose;
  return {space.settle(e.pose.position, kShoulder), e.pose.heading};
}

}  // namespace

Outlook::Approach Outlook::approach(const View& view, const Cue& cue, const Demand& demand) const noexcept {
  const Estimate& e = *view.estimate;
  Approach way;
  way.blur = demand.sigmas * std::min(e.sigma_m, kMostBlur);
  way.wobble = std::clamp(demand.sigmas * e.sigma_heading_rad, kWobble, kMostWobble);
  way.due = reaction_->way(cue, view.pace);
  way.latest = way.due + reaction_->spread_s() * view.pace + way.blur;
  return way;
}

bool Outlook::clear_of_walls(const View& view, const Approach& way, double direction,
                             const Demand& demand) const noexcept {
  const StraightWalk walk(*router_, view.estimate->room, in_room(*router_, *view.estimate), config_->body_m);
  // Who goes on anyhow is no worse off than they were.
  const double drift = direction == 0.0 ? 0.0 : std::sin(way.wobble);
  // All the way there too: somebody who touches a wall meanwhile stands still and does it where they are.
  const int stops = 1 + static_cast<int>(std::ceil(way.latest / kStops));
  for (int i = 0; i <= stops; ++i) {
    const double on = way.latest * i / stops;
    const StraightWalk::Place there = walk.after(on);
    for (const double side : {-1.0, 0.0, 1.0}) {
      const Vec2 then = unit_from_angle(there.pose.heading + direction + side * way.wobble);
      const FreeSpace& space = router_->space(there.room);
      if (!is_free(space, there.pose.position, then, way.blur, on * drift, demand.free_m)) return false;
    }
  }
  return true;
}

bool Outlook::clear_of_things(const View& view, const Approach& way, double direction,
                              const Demand& demand) const noexcept {
  const StraightWalk walk(*router_, view.estimate->room, in_room(*router_, *view.estimate), config_->body_m);
  const double needed = std::min(demand.free_m, kFaceThing);
  const double play = way.latest - way.due;
  for (const double on : {way.due - play, way.due + play, 0.0}) {
    const StraightWalk::Place there = walk.after(on);
    for (const double side : {-1.0, 1.0}) {
      const Vec2 then = unit_from_angle(there.pose.heading + direction + side * way.wobble);
      if (hindrances_->reach(there.room, view.now, there.pose.position, then, needed) < needed) return false;
    }
  }
  return true;
}

bool Outlook::clear_ahead(const View& view, const Cue& cue, double direction, const Demand& demand) const noexcept {
  const Approach way = approach(view, cue, demand);
  if (!clear_of_walls(view, way, direction, demand)) return false;
  return !demand.things || clear_of_things(view, way, direction, demand);
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
