#include "guidance/follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "guidance/surroundings.hpp"

namespace echoway::guidance {
namespace {

/// Below this the wearer stands, metres a second.
constexpr double kWalking = 0.25;
/// The point to head for lies at most this far along the way, metres,
constexpr double kLookAhead = 4.0;
/// and what is nearer than this is at hand already.
constexpr double kAtHand = 0.8;
/// Nearer to a door's wall than this, a doorway can be entered only from at most so far off its axis, metres.
constexpr double kNearWall = 0.7;
constexpr double kAside = 0.2;
/// From the chest's middle to where a wall is brushed, metres.
constexpr double kShoulder = 0.2;
/// Too near to be headed for, metres.
constexpr double kTooNear = 0.35;
/// A wearer who is to go straight is put right first if they face this far off.
constexpr double kFacingWell = degrees(9.0);
/// Less than this is no use saying, whatever it leads to.
constexpr double kWorthBending = degrees(4.0);
/// Beside the middle of a doorway by this much still goes through, metres.
constexpr double kDoorMiss = 0.18;

/// What a turn must leave free, first what is best; where there is so little room, less must do.
constexpr std::array<Demand, 3> kDemands{{{}, {0.55, 1.0}, {0.5, 0.0}}};
/// Who is to walk on must not have a thing before them that no plan knows, of which only some points are known, metres.
constexpr double kFaceThing = 0.4;
/// How ill a turn is made.
constexpr double kWobble = degrees(8.0);
/// A position is taken to be off by so much at most, metres.
constexpr double kMostBlur = 0.2;
/// Places at most this far apart are looked at on the way to where a turn is made, metres.
constexpr double kStops = 0.3;
/// What walkers who were told the same may be apart in time, seconds: at first, and once their reaction is known.
constexpr double kStranger = 0.35;
constexpr double kAcquaintance = 0.15;

/// What wearers make of a direction that they are told by sides: its sector's middle.
double understood(double direction) noexcept {
  const double side = direction > 0.0 ? 1.0 : -1.0;
  switch (sector_of(direction)) {
    case Sector::ahead:
      return 0.0;
    case Sector::slightly_left:
    case Sector::slightly_right:
      return side * degrees(32.0);
    case Sector::left:
    case Sector::right:
      return side * degrees(85.0);
    case Sector::sharp_left:
    case Sector::sharp_right:
      return side * degrees(140.0);
    case Sector::behind:
      break;
  }
  return kPi;
}

/// The direction to tell for a turn of `off`: "left" is understood as a right angle, so that a little more than half of
/// one is better told as "slightly left".
double told(double off) noexcept {
  constexpr double kMiddle = degrees(58.0);
  const double most_slight = degrees(45.0);
  const bool between = std::abs(off) > most_slight && std::abs(off) < kMiddle;
  return between ? std::copysign(most_slight, off) : off;
}

double heading_of(Vec2 from, Vec2 to) { return std::atan2(to.y - from.y, to.x - from.x); }

bool is_suffix(const std::vector<std::int32_t>& tail, const std::vector<std::int32_t>& whole) {
  return tail.size() <= whole.size() && std::equal(tail.rbegin(), tail.rend(), whole.rbegin());
}

}  // namespace

void Follower::lead_to(RouteTree tree) {
  stop();
  tree_ = std::move(tree);
  mode_ = Mode::tree;
}

void Follower::lead_back(std::vector<Spot> crumbs) {
  stop();
  crumbs_ = std::move(crumbs);
  mode_ = Mode::crumbs;
}

void Follower::stop() {
  mode_ = Mode::none;
  route_.clear();
  line_.clear();
  doors_.clear();
  new_way_ = false;
  straight_due_ = true;
  least_cost_ = 1e300;
  next_look_ = hold_until_ = last_said_ = -1e300;
  told_door_ = told_link_ = -1;
  told_narrow_ = false;
  arrived_at_ = -1.0;
  suspended_until_ = -1e300;
  landing_ = kNoRoom;
  bound_for_.room = kNoRoom;
  stretch_m_ = -1.0;
  hindrances_.clear();
}

void Follower::start_over() {
  transition_.reset();
  turn_told_until_ = -1.0;  // a heading that jumps is no turn to learn from
  if (mode_ == Mode::tree) {
    lead_to(std::move(tree_));
  } else {
    stop();
  }
}

double Follower::lead(const View& view, const Cue& cue) const noexcept {
  return view.speed * (spoken_seconds(cue, *config_) + reaction_s_);
}

/// A turn has been told: look how long it takes until it is made.
void Follower::time_reaction(const View& view, const Cue& cue) noexcept {
  const double direction = cue.tail.present ? cue.tail.direction : cue.direction;
  if (std::abs(direction) < degrees(45.0) || (cue.tail.present && cue.tail.kind != CueKind::turn)) return;
  turn_told_until_ = view.now + spoken_seconds(cue, *config_);
  turn_told_from_ = view.estimate->pose.heading;
  turn_told_left_ = direction > 0.0;
}

void Follower::learn_reaction(const Estimate& e) noexcept {
  if (turn_told_until_ < 0.0) return;
  constexpr double kSeen = degrees(25.0);    // turned by this much, the turn has begun
  constexpr double kSeenAfter = 0.28;        // which takes this long, s
  constexpr double kTooLong = 3.0;           // it was not taken in
  constexpr int kTrust = 6;
  const double after = e.time_s - turn_told_until_;
  const double turned = wrap_angle(e.pose.heading - turn_told_from_);
  if (after > kTooLong) turn_told_until_ = -1.0;
  if ((turn_told_left_ ? turned : -turned) < kSeen) return;
  turn_told_until_ = -1.0;
  reactions_ = std::min(reactions_ + 1, kTrust);
  reaction_s_ += (std::clamp(after - kSeenAfter, 0.2, 2.0) - reaction_s_) / (reactions_ + 1.0);
}

Follower::Approach Follower::approach(const View& view, const Cue& cue, const Demand& demand) const noexcept {
  const Estimate& e = *view.estimate;
  const double spread = reactions_ < 2 ? kStranger : kAcquaintance;
  Approach way;
  way.ahead = unit_from_angle(e.pose.heading);
  way.blur = demand.sigmas * std::min(e.sigma_m, kMostBlur);
  way.due = lead(view, cue);
  way.latest = way.due + spread * view.speed + way.blur;
  way.until_wall = std::max(0.0, router_->space(e.room).reach(e.pose.position, way.ahead, 10.0) - config_->body_m);
  return way;
}

/// True when a wearer who has done as they were told, where and when they will come to it, faces no wall.
bool Follower::clear_of_walls(const View& view, const Approach& way, double direction, const Demand& demand) const noexcept {
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

/// The same of things that no plan knows.
bool Follower::clear_of_things(const View& view, const Approach& way, double direction, const Demand& demand) const noexcept {
  const Pose2& pose = view.estimate->pose;
  const double needed = std::min(demand.free_m, kFaceThing);
  const double play = way.latest - way.due;
  for (const double on : {way.due - play, way.due + play, 0.0}) {
    const Vec2 there = pose.position + std::min(on, way.until_wall) * way.ahead;
    for (const double side : {-1.0, 1.0}) {
      const Vec2 then = unit_from_angle(pose.heading + direction + side * kWobble);
      if (hindrances_.reach(view.estimate->room, view.now, there, then, needed) < needed) return false;
    }
  }
  return true;
}

bool Follower::clear_ahead(const View& view, const Cue& cue, double direction, const Demand& demand) const noexcept {
  const Approach way = approach(view, cue, demand);
  return clear_of_walls(view, way, direction, demand) && clear_of_things(view, way, direction, demand);
}

/// True when a walker who goes on like this brushes a wall before the next point, though the way to it is clear.
bool Follower::grazes(const View& view) const noexcept {
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

std::optional<LevelTransition> Follower::take_transition() noexcept { return std::exchange(transition_, std::nullopt); }

/// The door or stairs of the way so far, while the wearer is in the same room.
BoundFor Follower::bound_for(const Estimate& e) const {
  for (const Waypoint& w : route_.waypoints) {
    const bool out = w.kind == WaypointKind::door || w.kind == WaypointKind::link_from;
    if (w.room == e.room && out) return {w.kind, w.index, config_->other_way_m + 2.0 * std::min(e.sigma_m, 1.0)};
    if (out) break;
  }
  return {};
}

bool Follower::find_way(const Estimate& e) {
  const Spot here{e.room, e.pose.position};
  if (mode_ == Mode::tree) {
    if (!router_->route_from(here, tree_, route_, bound_for(e))) return false;
  } else {
    Result<Route> back = router_->retrace(here, crumbs_);
    if (!back) return false;
    route_ = std::move(*back);
  }
  lay_out(route_, router_->building(), line_);
  hindrances_.bend(router_->space(e.room), e.room, e.time_s, line_);
  new_doors_.clear();
  for (const Waypoint& w : route_.waypoints) {
    if (w.kind == WaypointKind::door || w.kind == WaypointKind::link_from) new_doors_.push_back(w.index);
  }
  // Doors passed drop off the front; a door just passed comes back for a moment when the room is in doubt.
  const bool same = is_suffix(new_doors_, doors_) || (new_doors_.size() == doors_.size() + 1 && is_suffix(doors_, new_doors_));
  if (!same && !doors_.empty()) {
    new_way_ = true;
    straight_due_ = true;
    least_cost_ = route_.cost;
  }
  if (!same || is_suffix(new_doors_, doors_)) doors_ = new_doors_;
  return true;
}

Follower::View Follower::look(const Estimate& e, bool vague) {
  View view;
  view.estimate = &e;
  view.now = e.time_s;
  view.vague = vague;
  view.speed = std::isfinite(e.speed_mps) ? std::clamp(e.speed_mps, 0.0, 2.0) : 0.0;
  view.walking = view.speed > kWalking;
  if (!view.walking) view.speed = 0.0;
  view.remaining = walked_length(route_);
  view.turn = next_manoeuvre(line_, config_->ahead_rad, config_->fuse_m);
  aim(view);
  return view;
}

/// True when the wearer can go straight to `at`, which lies before the first door of the line or just beyond it.
bool Follower::in_reach(const Estimate& e, Vec2 at) const {
  const FreeSpace& space = router_->space(e.room);
  if (hindrances_.hinders({e.pose.position, at})) return false;
  if (space.clear_between(e.pose.position, at, config_->body_m)) return true;
  const auto door = std::find_if(line_.begin(), line_.end(), [](const LinePoint& p) { return p.kind == WaypointKind::door; });
  if (door == line_.end()) return false;
  for (const Passage& p : space.passages()) {
    if (p.door != door->index || p.inward == Vec2{}) continue;
    const double before = dot(e.pose.position - p.centre, p.inward);
    const double behind = dot(at - p.centre, p.inward);
    // Not too slantwise: the far jamb must not come near.
    constexpr double kSlant = 0.7;  // cosine of 45 degrees
    if (behind > 0.0 || before - behind < kSlant * distance(at, e.pose.position)) return false;
    // Beside the opening and close to its wall: back to where it can be entered squarely.
    const double aside = std::abs(dot(e.pose.position - p.centre, perpendicular(p.inward)));
    if (before < kNearWall && aside > (through_ ? kAside + 0.1 : kAside)) return false;
    const Vec2 crossing = e.pose.position + (std::max(before, 0.0) / (before - behind)) * (at - e.pose.position);
    const double half = 0.5 * router_->building().doors[static_cast<std::size_t>(p.door)].width;
    const double play = std::max(half - config_->body_m, 0.5 * kDoorMiss);
    return distance(crossing, p.centre) <= (through_ ? play : 0.6 * play);
  }
  return false;
}

/// Close before a doorway and beside its middle: straight at the middle and on, if the frame leaves room for that.
std::optional<Vec2> Follower::slant_through_door(const Estimate& e, bool begun) const {
  if (line_.size() < 2) return std::nullopt;
  const auto door = std::find_if(line_.begin(), line_.end(), [](const LinePoint& p) { return p.kind == WaypointKind::door; });
  if (door == line_.end()) return std::nullopt;
  for (const Passage& p : router_->space(e.room).passages()) {
    if (p.door != door->index || p.inward == Vec2{}) continue;
    const Vec2 from = e.pose.position - p.centre;
    const double before = dot(from, p.inward);
    const double aside = std::abs(dot(from, perpendicular(p.inward)));
    const double width = router_->building().doors[static_cast<std::size_t>(p.door)].width;
    const double away = norm(from);
    // Given up later than it is taken up.
    const double slack = begun ? 1.25 : 1.0;
    const bool near = before * slack >= 0.12 && before <= kNearWall * slack && aside <= 0.5 * width * slack;
    if (!near || width * before * slack < 2.0 * config_->body_m * away) return std::nullopt;
    // So close, a small error of position is a large one of direction: whoever faces the opening anyhow may walk on.
    const Vec2 ahead = unit_from_angle(e.pose.heading);
    const double slope = -dot(ahead, p.inward);
    constexpr double kNotTooSlant = 0.6;  // cosine
    if (slope > kNotTooSlant) {
      const double on = before / slope;
      const double beside = std::abs(dot(from + on * ahead, perpendicular(p.inward)));
      if (beside + 0.2 + std::min(e.sigma_m, 0.2) < 0.5 * width * slack) return e.pose.position + (on + 0.35) * ahead;
    }
    return p.centre - (0.35 / away) * from;
  }
  return std::nullopt;
}

bool Follower::still_bound_for(const Estimate& e) const {
  constexpr double kThere = 0.3;
  constexpr double kLongest = 20.0;
  return bound_for_.room == e.room && e.time_s - bound_since_ < kLongest && !new_way_ &&
         distance(e.pose.position, bound_for_.at) > kThere && in_reach(e, bound_for_.at);
}

void Follower::aim(View& view) {
  const Estimate& e = *view.estimate;
  const double lead = this->lead(view, make_cue(CueKind::turn));
  // Head for the next turn or the spot before the next door; when that is at hand, for a spot beyond it.
  double door_along = 1e9;
  double along = 0.0;
  for (std::size_t i = 1; i < line_.size() && door_along > 1e8; ++i) {
    along += distance(line_[i - 1].at, line_[i].at);
    if (line_[i].kind == WaypointKind::door) door_along = along;
  }
  const double to_door = door_along - router_->config().door_run_up_m;
  // A turn beyond a doorway is made well inside the room, one before it rather early than late.
  const bool beyond_door = door_along < view.turn.distance;
  view.at_turn = view.turn.present && view.walking && view.turn.distance <= lead + (beyond_door ? 0.0 : 0.2) &&
                 (!beyond_door || lead >= door_along + 0.4);
  double limit = std::max(length_of(line_), kAtHand);
  if (view.turn.present) limit = std::min(limit, view.turn.distance > kAtHand ? view.turn.distance : view.turn.distance + 1.0);
  if (door_along < 1e8) limit = std::min(limit, to_door > kAtHand ? to_door : door_along + 1.0);
  // Not from one to the other and back: going through a doorway slantwise is taken up late and given up late.
  const bool beyond = view.turn.present ? limit > view.turn.distance : limit > door_along;
  view.target = point_along(line_, std::min(0.5 * limit, kAtHand));
  bool through = false;
  for (const double share : {1.0, 0.75, 0.5}) {
    const Vec2 at = point_along(line_, std::min(share * limit, kLookAhead));
    if (!in_reach(e, at)) continue;
    view.target = at;
    through = beyond && share == 1.0;
    break;
  }
  if (beyond && !through) {
    const double back = view.turn.present ? std::min(view.turn.distance, door_along) : to_door;
    if (back > kTooNear) view.target = point_along(line_, back);
  }
  const auto slant = slanting_ || (beyond && !through) ? slant_through_door(e, slanting_) : std::nullopt;
  slanting_ = slant.has_value();
  if (slanting_) {
    view.target = *slant;
  } else if (still_bound_for(e)) {
    view.target = bound_for_.at;
  } else {
    bound_for_.room = kNoRoom;
  }
  through_ = through;
  view.target_away = distance(e.pose.position, view.target);
  const bool doorway = to_door < kLookAhead;
  const double clear = router_->space(e.room).clearance(view.target, 1.0);
  view.room_to_miss = doorway ? kDoorMiss : std::clamp(clear - config_->body_m, kDoorMiss, 0.6);
  const double heading = view.at_turn              ? view.turn.heading
                         : view.target_away > 0.15 ? heading_of(e.pose.position, view.target)
                                                   : e.pose.heading;
  view.off = wrap_angle(heading - e.pose.heading);
}

/// Who was told how far to go and stands well short of it, or does not even set off when told again, has met something
/// that no sensor saw.
void Follower::note_touch(const View& view) noexcept {
  const Estimate& e = *view.estimate;
  if (stretch_m_ < 0.0) return;
  if (stretch_from_.room != e.room) {
    stretch_m_ = -1.0;
    stood_ = 0;
    return;
  }
  if (view.walking) stretch_begun_ = true;
  constexpr double kStands = 1.5;    // s
  constexpr double kSetsOff = 3.0;   // s after the line and the reaction to it
  constexpr double kShort = 0.7;     // share of what was told
  constexpr double kAhead = 0.35;    // from the wearer's middle to what was touched, metres
  constexpr int kTold = 2;
  const bool stands = !view.walking && view.now - still_since_ >= kStands;
  const bool waits = stands && !stretch_begun_ && view.now > hold_until_ + kSetsOff;
  if (!waits && !(stands && stretch_begun_)) return;
  const double gone = distance(e.pose.position, stretch_from_.at);
  const bool well_short = gone < kShort * stretch_m_ && stretch_m_ - gone > 0.6;
  stood_ = waits ? stood_ + 1 : 0;
  if (well_short && (stretch_begun_ || stood_ >= kTold)) {
    hindrances_.touch(e.room, e.pose, kAhead, view.now);
    stood_ = 0;
  } else if (waits) {
    straight_due_ = true;
  }
  stretch_m_ = -1.0;
}

void Follower::note_progress(const View& view) {
  least_cost_ = std::min(least_cost_, route_.cost);
  if (view.walking || was_walking_ != view.walking) still_since_ = view.now;
  was_walking_ = view.walking;
  note_touch(view);
  if (told_door_ >= 0 && std::find(new_doors_.begin(), new_doors_.end(), told_door_) == new_doors_.end()) told_door_ = -1;
}

bool Follower::on_stairs(const Estimate& e) noexcept {
  if (landing_ == kNoRoom) return false;
  if (e.room == landing_ || e.time_s >= suspended_until_) {
    landing_ = kNoRoom;
    suspended_until_ = -1e300;
    straight_due_ = true;
    told_link_ = -1;
    return false;
  }
  return true;
}

void Follower::update(const Estimate& e, bool vague, bool turning, Announcer& voice) {
  learn_reaction(e);
  const bool sent_off = landing_ != kNoRoom;
  if (!active() || e.time_s < next_look_ || on_stairs(e)) return;
  if (sent_off) voice.forget_instruction();
  next_look_ = e.time_s + config_->renew_s;
  if (!find_way(e)) {
    if (e.time_s - last_said_ > 3.0 * config_->repeat_gap_s && voice.offer(make_cue(CueKind::no_way), e.time_s)) {
      last_said_ = e.time_s;
    }
    return;
  }
  if (e.room != in_room_) in_room_since_ = e.time_s;
  in_room_ = e.room;
  const View view = look(e, vague);
  note_progress(view);
  if (linger(view) || arrive(view, voice) || take_link(view, voice) || view.now < hold_until_) return;
  if (halt(view, voice) || turning || steer(view, voice) || go_on(view, voice)) return;
  (void)tell_ahead(view, voice);
}

Cue Follower::goal_cue(CueKind kind) const {
  Cue cue = make_cue(kind);
  switch (route_.goal.kind) {
    case Goal::Kind::place:
      cue.landmark = {CueLandmark::Kind::place, route_.goal.index};
      break;
    case Goal::Kind::exit:
    case Goal::Kind::nearest_exit:
      cue.landmark = {CueLandmark::Kind::exit, route_.goal.index};
      break;
    case Goal::Kind::room:
      cue.landmark = {CueLandmark::Kind::room, route_.goal.index};
      break;
    case Goal::Kind::spot:
      break;
  }
  return cue;
}

bool Follower::arrive(const View& view, Announcer& voice) {
  const Waypoint& goal = route_.waypoints.back();
  const Estimate& e = *view.estimate;
  if (goal.room != e.room) return false;
  // Before a doorway the room flickers: who is to go just inside is not there yet. And who is told that they are there
  // asks no further.
  constexpr double kSureOfRoom = 0.85;
  constexpr double kInRoom = 1.0;  // s
  const bool known = e.state == TrackState::tracking && e.sigma_m <= config_->found_sigma_m && e.room_probability >= kSureOfRoom &&
                     view.now - in_room_since_ >= kInRoom;
  if (arrived_at_ < 0.0 && !known) return false;
  Cue cue = goal_cue(CueKind::arrived);
  // Its first word is enough to stop at.
  const double lead = this->lead(view, make_cue(CueKind::stop));
  // Said early only to somebody who walks straight up to it, from a place that is well known.
  constexpr double kWellKnown = 0.3;  // m
  const bool approaching = view.walking && e.sigma_m <= kWellKnown && view.now >= hold_until_ && std::abs(view.off) <= config_->ahead_rad;
  const double near = approaching ? std::clamp(lead, config_->arrive_m, 1.6 * config_->arrive_m) : config_->arrive_m;
  const bool beside = distance(goal.at, e.pose.position) <= near &&
                      router_->space(e.room).clear_between(e.pose.position, goal.at, 0.1);
  if (view.remaining > near && !beside) return false;
  const auto point_at = [&](const std::vector<Landmark>& all) {
    const Vec2 at = all[static_cast<std::size_t>(route_.goal.index)].at;
    cue.has_direction = distance(at, e.pose.position) > 0.3;
    cue.direction = direction_to(e.pose, at);
  };
  if (cue.landmark.kind == CueLandmark::Kind::place) point_at(router_->building().places);
  if (cue.landmark.kind == CueLandmark::Kind::exit) point_at(router_->building().exits);
  if (arrived_at_ < 0.0 && voice.offer(cue, view.now)) arrived_at_ = view.now;
  return true;
}

/// After "arrived" the way is kept for a moment: a wearer who has not taken it in walks on and is led back.
bool Follower::linger(const View& view) {
  if (arrived_at_ < 0.0) return false;
  constexpr double kSettle = 4.0;
  if (view.now - arrived_at_ < kSettle) return true;
  const bool there = view.remaining < 1.5 * config_->arrive_m;
  if (there && !view.walking && !view.vague) stop();
  if (there || (view.walking && view.remaining < 2.0 * config_->arrive_m)) return true;
  arrived_at_ = -1.0;
  straight_due_ = true;
  return false;
}

bool Follower::take_link(const View& view, Announcer& voice) {
  const LinePoint& end = line_.back();
  if (end.kind != WaypointKind::link_from || length_of(line_) > config_->arrive_m + 0.5 * view.speed) return false;
  const LevelLink& link = router_->building().links[static_cast<std::size_t>(end.index)];
  const bool from_a = view.estimate->room == link.room_a;
  const RoomIndex to = from_a ? link.room_b : link.room_a;
  const bool stairs = link.kind == LevelLinkKind::stairs;
  Cue cue = make_cue(CueKind::take_link);
  cue.landmark = {CueLandmark::Kind::link, end.index};
  cue.up = router_->building().room(to).level > router_->building().room(view.estimate->room).level;
  cue.direction = direction_to(view.estimate->pose, end.at);
  cue.has_direction = true;
  if (!voice.offer(cue, view.now)) return true;
  const double patience = stairs ? config_->stairs_patience_s : config_->elevator_patience_s;
  landing_ = to;
  suspended_until_ = view.now + patience;
  transition_ = LevelTransition{static_cast<std::size_t>(end.index), view.estimate->room, to, view.now, patience};
  return true;
}

void Follower::hold_after(const Cue& cue, const View& view) {
  const double now = view.now;
  if (cue.kind != CueKind::bear) stretch_m_ = -1.0;
  constexpr double kNear = 2.0;
  const bool sent = cue.kind != CueKind::stop || cue.tail.present;
  if (sent && !slanting_ && !view.at_turn && view.target_away < kNear && bound_for_.room != view.estimate->room) {
    bound_for_ = {view.estimate->room, view.target};
    bound_since_ = now;
  }

  const double turning = cue.kind == CueKind::turn || cue.tail.present ? 0.6 + std::abs(cue.tail.present ? cue.tail.direction : cue.direction) / degrees(90.0) : 0.6;
  hold_until_ = now + spoken_seconds(cue, *config_) + reaction_s_ + turning;
  last_said_ = now;
}

/// A wall in the walking direction, nearer than the wearer can be turned in: stop first.
bool Follower::halt(const View& view, Announcer& voice) {
  if (!view.walking || view.vague) return false;
  const Pose2& pose = view.estimate->pose;
  Cue cue = make_cue(CueKind::stop);
  const double lead = this->lead(view, cue) + 0.2 * view.speed;
  const double free = router_->space(view.estimate->room).reach(pose.position, unit_from_angle(pose.heading), 10.0);
  if (free - config_->body_m > lead) return false;
  // On the way to a spot before that wall, where the wearer was told to go.
  if (std::abs(view.off) <= config_->ahead_rad && view.target_away < free - config_->body_m) return false;
  const double turn = told(view.off);
  if (sector_of(turn) != Sector::ahead && clear_ahead(view, cue, understood(turn), {})) {
    cue.tail = {CueKind::turn, true, turn, -1.0};
  }
  if (!cue.tail.present || !voice.offer(cue, view.now)) return stop_walker(view, voice);
  straight_due_ = true;
  hold_after(cue, view);
  return true;
}

/// "Stop." once in a while; sooner after the last one "Stop. Door left.", which are other words.
bool Follower::stop_walker(const View& view, Announcer& voice) {
  Cue cue = make_cue(CueKind::stop);
  if (!voice.would_speak(cue, view.now)) {
    const auto door = std::find_if(line_.begin(), line_.end(), [](const LinePoint& p) { return p.kind == WaypointKind::door; });
    if (door == line_.end()) return false;
    cue.tail = {CueKind::door, true, direction_to(view.estimate->pose, door->at), -1.0};
  }
  if (!voice.offer(cue, view.now)) return false;
  straight_due_ = true;
  hold_after(cue, view);
  return true;
}

/// A turn would face the wearer with a wall. Walkers are stopped first, where it is to be made. Whoever stands is sent
/// another way by a step or two, from where the turn can be told.
bool Follower::turn_in_tight_spot(const View& view, const Demand& demand, Announcer& voice) {
  if (view.walking) {
    const Cue stop = make_cue(CueKind::stop);
    if (view.at_turn && view.turn.distance > lead(view, stop)) return true;  // not yet
    return stop_walker(view, voice) || !voice.is_free(view.now);
  }
  const FreeSpace& space = router_->space(view.estimate->room);
  const Pose2& pose = view.estimate->pose;
  constexpr std::array<double, 8> kWays{0.0, degrees(32.0), degrees(-32.0), degrees(85.0), degrees(-85.0), degrees(140.0), degrees(-140.0), kPi};
  constexpr std::array<double, 4> kSteps{0.35, 0.6, 0.9, 1.3};
  const Approach from_here = approach(view, make_cue(CueKind::turn), demand);
  double best = 1e300;
  double way = 0.0;
  double length = 0.0;
  for (const double direction : kWays) {
    for (const double step : kSteps) {
      const Vec2 there = pose.position + step * unit_from_angle(pose.heading + direction);
      const double cost = step + std::abs(wrap_angle(direction - view.off)) * 0.4;
      if (cost >= best || !space.clear_between(pose.position, there, config_->body_m)) continue;
      if (hindrances_.hinders({pose.position, there})) continue;
      Estimate then = *view.estimate;
      then.pose = {there, wrap_angle(pose.heading + direction)};
      const View seen{.estimate = &then, .now = view.now};
      const double off = told(direction_to(then.pose, view.target));
      if (!in_reach(then, view.target) || !clear_ahead(seen, make_cue(CueKind::turn), understood(off), demand)) continue;
      if (!clear_of_walls(view, from_here, direction, demand)) continue;
      best = cost;
      way = direction;
      length = step;
    }
  }
  if (best > 1e299) return false;
  Cue cue = make_cue(way == 0.0 ? CueKind::go_straight : CueKind::turn);
  if (way == 0.0) {
    cue.distance_m = length;
  } else {
    cue.direction = way;
    cue.has_direction = true;
    cue.tail = {CueKind::go_straight, true, 0.0, length};
  }
  if (!voice.offer(cue, view.now)) return false;
  straight_due_ = true;
  hold_after(cue, view);
  hold_until_ += length / 0.7;
  return true;
}

bool Follower::say_turn(const View& view, Announcer& voice) {
  const double turn = told(view.off);
  Cue cue = make_cue(CueKind::turn);
  cue.direction = turn;
  cue.has_direction = true;
  const bool again = view.walking && voice.is_free(view.now) && !voice.would_speak(cue, view.now);
  if (again && turn_in_tight_spot(view, {}, voice)) return true;
  // In a tight spot less must do, rather than nothing; a walker is stopped instead.
  for (const Demand& demand : kDemands) {
    if (clear_ahead(view, cue, understood(turn), demand)) break;
    if (turn_in_tight_spot(view, demand, voice)) return true;
    if (view.walking) break;
  }
  const bool astray = route_.cost > least_cost_ + config_->wrong_way_m + 2.0 * view.estimate->sigma_m;
  if (new_way_ || (astray && std::abs(view.off) > degrees(100.0))) {
    cue.tail = {CueKind::turn, true, turn, -1.0};
    cue.kind = new_way_ ? CueKind::rerouted : CueKind::wrong_way;
    cue.has_direction = false;
    cue.direction = 0.0;
  }
  if (!voice.would_speak(cue, view.now) && cue.kind == CueKind::turn) {
    // The same words were said a moment ago and did not do, or are needed again: more words make them new. A walker is
    // told how it goes on; whoever stands has to be put right first.
    if (view.walking && view.at_turn) {
      cue.tail = {CueKind::go_straight, true, 0.0, view.turn.run_out};
    } else {
      cue.tail = {CueKind::turn, true, turn, -1.0};
      cue.kind = CueKind::stop;
      cue.urgency = Urgency::turn;
      cue.has_direction = false;
      cue.direction = 0.0;
    }
  }
  if (!voice.offer(cue, view.now)) return false;
  time_reaction(view, cue);
  new_way_ = false;
  least_cost_ = route_.cost;
  straight_due_ = !(cue.tail.present && cue.tail.kind == CueKind::go_straight);
  hold_after(cue, view);
  return true;
}

bool Follower::steer(const View& view, Announcer& voice) {
  const double off = std::abs(view.off);
  if (view.vague && off <= degrees(45.0)) return false;
  if (off > config_->ahead_rad && (!view.walking || view.at_turn || off > degrees(35.0))) return say_turn(view, voice);
  if (!view.walking || view.vague || view.at_turn) return false;
  // Walking a little off: only what would miss the next point by too much is worth a word.
  const double noise = 2.0 * std::min(view.estimate->sigma_heading_rad, degrees(5.0));
  const double miss = view.target_away * std::sin(std::min(off, kPi / 2));
  const bool misses = off >= degrees(6.0) + 0.5 * noise && miss >= view.room_to_miss;
  if (!misses && !(off >= kWorthBending && grazes(view))) return false;
  if (off > degrees(22.0)) return say_turn(view, voice);
  Cue cue = make_cue(CueKind::bear);
  cue.direction = view.off;
  cue.has_direction = true;
  const double needed = lead(view, cue);
  // Left alone when a turn to the other side is due so soon that it would have to wait for this to be forgotten.
  const double turn_off = wrap_angle(view.turn.heading - view.estimate->pose.heading);
  const bool countered = view.turn.present && turn_off * view.off < 0.0 &&
                         view.turn.distance < view.speed * config_->contradiction_gap_s + needed;
  if (countered || view.target_away < needed || !voice.offer(cue, view.now)) return false;
  hold_after(cue, view);
  return true;
}

/// "Go straight", once a leg; again to a wearer who stands on a clear way for long.
bool Follower::go_on(const View& view, Announcer& voice) {
  const bool stands = !view.walking && view.now - std::max(still_since_, last_said_) > config_->nudge_s;
  if (!(straight_due_ || stands) || std::abs(view.off) > config_->ahead_rad) return false;
  Cue cue = make_cue(CueKind::go_straight);
  const bool amend = !view.walking && !view.vague && !new_way_ && std::abs(view.off) > kFacingWell;
  double along = view.turn.present ? view.turn.distance : length_of(line_);
  if (view.at_turn) along += view.turn.run_out;
  else if (view.turn.present && along < kAtHand) along = view.target_away;
  if (view.walking && along < lead(view, cue)) return false;
  const double free = std::min(Demand{}.free_m, 0.8 * along);
  const double direction = amend ? view.off : 0.0;
  const Demand demand{free, Demand{}.sigmas};
  const Approach way = approach(view, cue, demand);
  if (!clear_of_walls(view, way, direction, demand) || !(amend || clear_of_things(view, way, direction, demand))) return false;
  cue.distance_m = along;
  cue.sigma_m = view.estimate->sigma_m;
  if (new_way_) {
    cue.kind = CueKind::rerouted;
    cue.tail = {CueKind::go_straight, true, 0.0, cue.distance_m};
    cue.distance_m = -1.0;
  }
  if (amend) {
    cue.kind = CueKind::bear;
    cue.direction = view.off;
    cue.has_direction = true;
    cue.tail = {CueKind::go_straight, true, 0.0, cue.distance_m};
    cue.distance_m = -1.0;
  }
  if (!voice.offer(cue, view.now)) return false;
  new_way_ = false;
  straight_due_ = false;
  stretch_m_ = along;
  stretch_from_ = {view.estimate->room, view.estimate->pose.position};
  stretch_begun_ = view.walking;
  hold_until_ = view.now + spoken_seconds(cue, *config_) + reaction_s_ + (amend ? 0.8 : 0.4);
  last_said_ = view.now;
  return true;
}

bool Follower::tell_link(const View& view, std::int32_t index, double along, Vec2 at, Announcer& voice) {
  if (told_link_ == index) return false;
  const LevelLink& link = router_->building().links[static_cast<std::size_t>(index)];
  const RoomIndex here = view.estimate->room;
  const RoomIndex to = link.room_a == here ? link.room_b : link.room_a;
  Cue cue = make_cue(link.kind == LevelLinkKind::stairs ? CueKind::stairs : CueKind::elevator);
  cue.direction = direction_to(view.estimate->pose, at);
  cue.has_direction = true;
  cue.distance_m = along;
  cue.sigma_m = view.estimate->sigma_m;
  cue.landmark = {CueLandmark::Kind::link, index};
  cue.up = router_->building().room(to).level > router_->building().room(here).level;
  if (!voice.offer(cue, view.now)) return false;
  told_link_ = index;
  return true;
}

bool Follower::tell_ahead(const View& view, Announcer& voice) {
  if (view.vague || !voice.is_free(view.now)) return false;
  const Pose2& pose = view.estimate->pose;
  if (route_.narrow(router_->config()) && !told_narrow_) {
    Cue cue = make_cue(CueKind::narrow);
    told_narrow_ = voice.offer(cue, view.now);
    return told_narrow_;
  }
  double along = 0.0;
  for (std::size_t i = 1; i < line_.size(); ++i) {
    along += distance(line_[i - 1].at, line_[i].at);
    if (along > config_->door_cue_m) return false;
    if (line_[i].kind == WaypointKind::link_from) return tell_link(view, line_[i].index, along, line_[i].at, voice);
    if (line_[i].kind != WaypointKind::door) continue;
    Cue cue = make_cue(CueKind::door);
    cue.distance_m = along;
    cue.sigma_m = view.estimate->sigma_m;
    cue.direction = direction_to(pose, line_[i].at);
    cue.has_direction = true;
    cue.landmark = {CueLandmark::Kind::door, line_[i].index};
    const double needed = lead(view, cue);
    const double until = view.turn.present ? std::min(along, view.turn.distance) : along;
    const double turn_lead = view.turn.present ? view.speed * 2.0 : 0.0;
    if (told_door_ == line_[i].index || until < needed + turn_lead) return false;
    if (!voice.offer(cue, view.now)) return false;
    told_door_ = line_[i].index;
    return true;
  }
  return false;
}

CueTail Follower::next_step(const Estimate& e) {
  if (!active() || !find_way(e)) return {};
  const View view = look(e, false);
  straight_due_ = true;
  new_way_ = false;
  const Cue turn = make_cue(CueKind::turn);
  if (std::abs(view.off) <= config_->ahead_rad || !clear_ahead(view, turn, understood(view.off), {})) return {};
  hold_until_ = e.time_s + 3.0;
  return {CueKind::turn, true, view.off, -1.0};
}

}  // namespace echoway::guidance
