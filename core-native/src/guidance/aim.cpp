#include "guidance/aim.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::guidance {
namespace {

/// The point to head for lies at most this far along the way, metres.
constexpr double kLookAhead = 4.0;
/// Too near to be headed for, metres.
constexpr double kTooNear = 0.35;
/// A door so far along is none.
constexpr double kNoDoor = 1e8;

double heading_of(Vec2 from, Vec2 to) { return std::atan2(to.y - from.y, to.x - from.x); }

/// How far along to look at most: not beyond the next turn and door, unless they are at hand.
double limit_of(const View& view, std::span<const LinePoint> line, double door_along, double to_door) {
  double limit = std::max(length_of(line), kAtHand);
  const double turn = view.turn.distance;
  if (view.turn.present) limit = std::min(limit, turn > kAtHand ? turn : turn + 1.0);
  if (door_along < kNoDoor) limit = std::min(limit, to_door > kAtHand ? to_door : door_along + 1.0);
  return limit;
}

}  // namespace

std::optional<Doorway> Aim::doorway(RoomIndex room) const noexcept {
  const LinePoint* door = way_->first_door().door;
  return door == nullptr ? std::nullopt : Doorway::of(*router_, room, door->index, config_->body_m);
}

bool Aim::in_reach(const Estimate& e, Vec2 at) const {
  if (way_->hindrances().hinders({e.pose.position, at})) return false;
  if (router_->space(e.room).clear_between(e.pose.position, at, config_->body_m)) return true;
  const auto door = doorway(e.room);
  return door && door->lets_through(e.pose.position, at, through_);
}

bool Aim::still_keeps(const Estimate& e) const {
  constexpr double kThere = 0.3;
  constexpr double kLongest = 20.0;
  return kept_.room == e.room && e.time_s - kept_since_ < kLongest && !way_->is_new() &&
         distance(e.pose.position, kept_.at) > kThere && in_reach(e, kept_.at);
}

void Aim::keep(const View& view) noexcept {
  constexpr double kNear = 2.0;
  if (slanting_ || view.at_turn || view.target_away >= kNear || kept_.room == view.estimate->room) return;
  kept_ = {view.estimate->room, view.target};
  kept_since_ = view.now;
}

/// The farthest point of the way that can be gone to straight.
Aim::Choice Aim::far_point(const View& view, double door_along) const {
  const auto line = way_->line();
  const double to_door = door_along - router_->config().door_run_up_m;
  const double limit = limit_of(view, line, door_along, to_door);
  const bool beyond = view.turn.present ? limit > view.turn.distance : limit > door_along;
  Vec2 target = point_along(line, std::min(0.5 * limit, kAtHand));
  for (const double share : {1.0, 0.75, 0.5}) {
    const Vec2 at = point_along(line, std::min(share * limit, kLookAhead));
    if (!in_reach(*view.estimate, at)) continue;
    if (!beyond || share == 1.0) return {at, beyond, beyond};
    target = at;
    break;
  }
  // The whole way cannot be gone to straight: to the turn or the spot before the door first.
  const double back = view.turn.present ? std::min(view.turn.distance, door_along) : to_door;
  return {beyond && back > kTooNear ? point_along(line, back) : target, beyond, false};
}

/// Not from one to the other and back: going through a doorway slantwise is taken up late and given up late.
Vec2 Aim::settle(const Estimate& e, const Choice& choice) {
  std::optional<Vec2> slant;
  if (slanting_ || (choice.beyond && !choice.through)) {
    const auto door = doorway(e.room);
    if (door && way_->line().size() >= 2) slant = door->slant(e.pose, e.sigma_m, slanting_);
  }
  if (slant && way_->hindrances().hinders({e.pose.position, *slant})) slant.reset();
  slanting_ = slant.has_value();
  const bool keeps = !slanting_ && still_keeps(e);
  through_ = choice.through;
  if (slanting_) return *slant;
  if (keeps) return kept_.at;
  forget();
  return choice.at;
}

void Aim::take(View& view) {
  const Pose2& pose = view.estimate->pose;
  const double lead = reaction_->way(make_cue(CueKind::turn), view.speed);
  const double door_along = way_->first_door().along;
  // A turn beyond a doorway is made well inside the room, one before it rather early than late.
  const bool beyond_door = door_along < view.turn.distance;
  view.at_turn = view.turn.present && view.walking && view.turn.distance <= lead + (beyond_door ? 0.0 : 0.2) &&
                 (!beyond_door || lead >= door_along + 0.4);
  view.target = settle(*view.estimate, far_point(view, door_along));
  view.target_away = distance(pose.position, view.target);
  const bool doorway = door_along - router_->config().door_run_up_m < kLookAhead;
  const double clear = router_->space(view.estimate->room).clearance(view.target, 1.0);
  view.room_to_miss = doorway ? kDoorMiss : std::clamp(clear - config_->body_m, kDoorMiss, 0.6);
  const double heading = view.at_turn              ? view.turn.heading
                         : view.target_away > 0.15 ? heading_of(pose.position, view.target)
                                                   : pose.heading;
  view.off = wrap_angle(heading - pose.heading);
}

}  // namespace echoway::guidance
