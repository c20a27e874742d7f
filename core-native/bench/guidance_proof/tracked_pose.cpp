#include "tracked_pose.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::proof {
namespace {

/// Where the way leads stays free, and no door is shut by chance.
sim::Footprint footprint_of(const Building& building, const Route& route) {
  sim::Footprint footprint;
  for (std::size_t i = 0; i < building.doors.size(); ++i) footprint.doors.insert(i);
  for (std::size_t i = 1; i < route.waypoints.size(); ++i) {
    const Waypoint& last = route.waypoints[i - 1];
    const Waypoint& here = route.waypoints[i];
    if (here.kind == WaypointKind::link_to) continue;
    const Vec2 from = last.kind == WaypointKind::door ? last.next_at : last.at;
    const int steps = 1 + static_cast<int>(distance(from, here.at) / 0.1);
    for (int k = 0; k <= steps; ++k) {
      footprint.step_on(here.room, from + (static_cast<double>(k) / steps) * (here.at - from));
    }
  }
  return footprint;
}

std::vector<double> bearings_of(const BeltConfig& config) {
  std::vector<double> bearings;
  for (int i = 0; i < config.sensors; ++i) bearings.push_back(config.bearing(i));
  return bearings;
}

BayesOptions options_of(std::uint64_t seed) {
  BayesOptions options;
  options.seed = seed;
  return options;
}

}  // namespace

TrackedPose::TrackedPose(const Router& router, const sim::World& world, const Route& route, const Start& start,
                         std::uint64_t seed, std::unique_ptr<test::NoisyTruth> truth)
    : building_(router.building()),
      world_(world),
      plan_(building_),
      belt_(plan_, config_, bearings_of(config_), world_, footprint_of(building_, route), seed),
      locator_(building_, config_, start, options_of(seed)),
      truth_(std::move(truth)),
      random_(seed + 17) {
  if (start.room) last_heading_ = start.heading.value_or(0.0) + building_.room(*start.room).frame.heading;
}

/// `turned` radians and `steps` steps since the last time.
void TrackedPose::sense_motion(double time_s, double turned, double steps) {
  const double dt = time_s - last_time_;
  if (dt <= 0.0) return;
  last_time_ = time_s;
  yaw_ += turned;
  const double noise = world_.gyro_noise_rad_s * random_.normal();
  if (world_.gyro) locator_.on_motion({time_s, MotionKind::yaw_rate, turned / dt + world_.gyro_bias_rad_s + noise});
  const bool stepped = std::floor(steps_ + steps) > std::floor(steps_);
  steps_ += steps;
  if (world_.steps && stepped && random_.uniform() >= world_.step_missed) {
    locator_.on_motion({time_s, MotionKind::step, 1.0});
  }
}

void TrackedPose::observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) {
  sim::Moment moment;
  moment.time_s = time_s;
  moment.room = room;
  moment.pose = pose;
  moment.speed = speed;
  moment.heading = wrap_angle(pose.heading + building_.room(room).frame.heading);
  sense_motion(time_s, wrap_angle(moment.heading - last_heading_),
               speed * (time_s - last_time_) / world_.step_length_m);
  last_heading_ = moment.heading;
  fire(moment, guide);
}

void TrackedPose::observe_between(double time_s, const test::Crossing& c, Guide& guide) {
  const Room& from = building_.room(c.from);
  const Room& to = building_.room(c.to);
  if (crossing_since_ != c.begins_s) {
    crossing_since_ = c.begins_s;
    last_crossed_ = {};
    crossing_ = LevelCrossing(building_.links[c.link].kind, std::max(1, std::abs(to.level - from.level)),
                              to.level >= from.level, c.link % 2 == 0 ? 1 : -1);
  }
  const double share = (time_s - c.begins_s) / (c.ends_s - c.begins_s);
  const LevelCrossing::Moment crossed = crossing_.at(share);
  sim::Moment moment;
  moment.time_s = time_s;
  moment.room = share < 0.5 ? c.from : c.to;
  moment.pose = share < 0.5 ? c.leaving : c.arriving;
  moment.between = crossed.place;
  moment.heading = wrap_angle(c.leaving.heading + from.frame.heading + crossed.turned);
  moment.pose.heading = wrap_angle(moment.heading - building_.room(moment.room).frame.heading);
  moment.speed = crossed.steps > last_crossed_.steps ? sim::stairs::kCadence * sim::stairs::kGoing : 0.0;
  sense_motion(time_s, crossed.turned - last_crossed_.turned, crossed.steps - last_crossed_.steps);
  last_crossed_ = crossed;
  last_heading_ = moment.heading;
  fire(moment, guide);
}

void TrackedPose::fire(const sim::Moment& at, Guide& guide) {
  sim::Moment moment = at;
  moment.yaw = yaw_;
  moment.stride = kPi * steps_;
  const Firing firing = belt_.fire(moment, static_cast<int>(index_ % config_.sensors), index_);
  ++index_;
  if (truth_ != nullptr) {
    guide.on_firing(firing);
    if (!moment.between.present) truth_->observe(moment.time_s, moment.room, moment.pose, moment.speed, guide);
    diary_.push_back({moment.time_s, moment.room, moment.pose, truth_->estimate()});
    return;
  }
  if (!locator_.on_firing(firing)) return;
  const Estimate& e = locator_.estimate();
  if (!moment.between.present) ++observations_;
  if (!moment.between.present && e.room == moment.room) {
    errors_.push_back(distance(e.pose.position, moment.pose.position));
  }
  diary_.push_back({moment.time_s, moment.room, moment.pose, e});
  guide.on_firing(firing);
  guide.on_estimate(e, locator_.hypotheses());
}

double TrackedPose::room_right() const noexcept {
  return observations_ == 0 ? 0.0 : static_cast<double>(errors_.size()) / static_cast<double>(observations_);
}

}  // namespace echoway::proof
