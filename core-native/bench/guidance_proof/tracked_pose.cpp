#include "tracked_pose.hpp"

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
    for (int k = 0; k <= steps; ++k) footprint.step_on(here.room, from + (static_cast<double>(k) / steps) * (here.at - from));
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
                         std::uint64_t seed)
    : building_(router.building()),
      world_(world),
      plan_(building_),
      belt_(plan_, config_, bearings_of(config_), world_, footprint_of(building_, route), seed),
      locator_(building_, config_, start, options_of(seed)),
      random_(seed + 17) {
  last_heading_ = start.heading.value_or(0.0);
}

void TrackedPose::sense_motion(const sim::Moment& m) {
  const double dt = m.time_s - last_time_;
  if (dt <= 0.0) return;
  const double turned = wrap_angle(m.pose.heading - last_heading_);
  yaw_ += turned;
  const double noise = world_.gyro_noise_rad_s * random_.normal();
  if (world_.gyro) locator_.on_motion({m.time_s, MotionKind::yaw_rate, turned / dt + world_.gyro_bias_rad_s + noise});
  const double before = std::floor(walked_ / world_.step_length_m);
  walked_ += m.speed * dt;
  const bool stepped = std::floor(walked_ / world_.step_length_m) > before;
  if (world_.steps && stepped && random_.uniform() >= world_.step_missed) {
    locator_.on_motion({m.time_s, MotionKind::step, 1.0});
  }
  last_time_ = m.time_s;
  last_heading_ = m.pose.heading;
}

void TrackedPose::observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) {
  sim::Moment moment;
  moment.time_s = time_s;
  moment.room = room;
  moment.pose = pose;
  moment.speed = speed;
  moment.heading = wrap_angle(pose.heading + building_.room(room).frame.heading);
  sense_motion(moment);
  moment.yaw = yaw_;
  moment.stride = kPi * walked_ / world_.step_length_m;
  const Firing firing = belt_.fire(moment, static_cast<int>(index_ % config_.sensors), index_);
  ++index_;
  if (!locator_.on_firing(firing)) return;
  const Estimate& e = locator_.estimate();
  ++observations_;
  if (e.room == room) errors_.push_back(distance(e.pose.position, pose.position));
  guide.on_firing(firing);
  guide.on_estimate(e, locator_.hypotheses());
}

double TrackedPose::room_right() const noexcept {
  return observations_ == 0 ? 0.0 : static_cast<double>(errors_.size()) / static_cast<double>(observations_);
}

}  // namespace echoway::proof
