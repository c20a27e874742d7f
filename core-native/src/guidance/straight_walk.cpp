#include "guidance/straight_walk.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::guidance {
namespace {

constexpr double kFar = 10.0;  // metres

/// How far it is from `from` along `unit` to a passage's opening, if they meet.
std::optional<double> meets(const Passage& p, double width, Vec2 from, Vec2 unit) noexcept {
  if (p.inward == Vec2{}) return std::nullopt;
  const double closing = -dot(unit, p.inward);
  const double before = dot(from - p.centre, p.inward);
  if (before < 0.0 || closing < 1e-6) return std::nullopt;
  const double on = before / closing;
  const double aside = std::abs(dot(from + on * unit - p.centre, perpendicular(p.inward)));
  return aside < 0.5 * width ? std::optional(on) : std::nullopt;
}

}  // namespace

StraightWalk::StraightWalk(const Router& router, RoomIndex room, const Pose2& from, double body_m) noexcept
    : room_(room), from_(from) {
  const Building& building = router.building();
  const FreeSpace& space = router.space(room);
  const Vec2 ahead = unit_from_angle(from.heading);
  until_wall_ = std::max(0.0, space.reach(from.position, ahead, kFar) - body_m);
  for (const Passage& p : space.passages()) {
    const Door& door = building.doors[static_cast<std::size_t>(p.door)];
    const auto on = meets(p, door.width, from.position, ahead);
    if (!on || *on > until_wall_ || (beyond_ && *on > beyond_->on)) continue;
    const RoomIndex next = door.beyond(room);
    const auto there = std::find_if(router.space(next).passages().begin(), router.space(next).passages().end(),
                                    [&](const Passage& q) { return q.door == p.door; });
    if (there == router.space(next).passages().end()) continue;
    // The next room's frame in this one's, hung up at the door.
    const double turn = building.room(room).frame.heading - building.room(next).frame.heading;
    const Pose2 crossing{there->centre + Pose2{{}, turn}.transform(from.position + *on * ahead - p.centre),
                         wrap_angle(from.heading + turn)};
    const double free = router.space(next).reach(crossing.position, unit_from_angle(crossing.heading), kFar);
    beyond_ = Beyond{*on, {next, crossing}, std::max(0.0, free - body_m)};
  }
}

StraightWalk::Place StraightWalk::after(double on) const noexcept {
  if (!beyond_ || on <= beyond_->on) {
    return {room_, {from_.position + std::min(on, until_wall_) * unit_from_angle(from_.heading), from_.heading}};
  }
  Place place = beyond_->in;
  const double inside = std::min(on - beyond_->on, beyond_->until_wall);
  place.pose.position = place.pose.position + inside * unit_from_angle(place.pose.heading);
  return place;
}

}  // namespace echoway::guidance
