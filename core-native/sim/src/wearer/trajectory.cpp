#include "wearer/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace echoway::sim {
namespace {

constexpr double kTurnRate = degrees(100.0);        // Fastest turn of a chest, rad/s.
constexpr double kTurnAcceleration = degrees(400.0);
constexpr double kTurnGain = 4.0;                   // 1/s: how eagerly the chest follows the way ahead.
constexpr double kStandAndTurn = degrees(50.0);     // Beyond this the wearer stops to turn.
constexpr double kAcceleration = 0.8;               // m/s^2
constexpr double kSpeedMemory = 4.0;                // s, correlation time of slow speed changes.
constexpr double kLongest = 24.0 * 3600.0;          // s; a walk longer than a day is a mistake.

// Moves the wearer in small steps of time and keeps what happened.
class Walker {
 public:
  Walker(const FloorPlan& plan, const Walk& walk, Random random, std::vector<Moment>& samples)
      : plan_(plan), world_(walk.world), cruise_(walk.speed_mps), random_(random), samples_(samples) {}

  Status start(const Place& place, double heading) {
    const Result<RoomIndex> room = find(place);
    if (!room.ok()) return room.error();
    room_ = *room;
    body_ = {place.at, heading};
    yaw_ = level_heading();
    record();
    return success();
  }

  Status operator()(const GoTo& step) {
    const Result<RoomIndex> room = find(step.to);
    if (!room.ok()) return room.error();
    const Result<std::vector<Stretch>> way = plan_.route(room_, body_.position, *room, step.to.at);
    if (!way.ok()) return way.error();
    for (const Stretch& stretch : *way) {
      if (stretch.room != room_) pass_door(stretch.room);
      for (const Vec2 point : stretch.points) walk_to(point);
    }
    return success();
  }
  Status operator()(const Pause& step) {
    const double until = time_ + step.seconds;
    while (time_ < until) tick(0.0, 0.0);
    return success();
  }
  Status operator()(const TurnBy& step) {
    const double goal = yaw_ + step.angle;
    while (std::abs(goal - yaw_) > degrees(1.0) || std::abs(turn_rate_) > degrees(5.0)) tick(0.0, goal - yaw_);
    return success();
  }
  Status operator()(const Teleport& step) {
    const Result<RoomIndex> room = find(step.to);
    if (!room.ok()) return room.error();
    room_ = *room;
    body_ = {step.to.at, step.heading};
    speed_ = turn_rate_ = 0.0;
    tick(0.0, 0.0);
    return success();
  }
  Status operator()(const SetSpeed& step) {
    cruise_ = step.mps;
    return success();
  }

 private:
  Result<RoomIndex> find(const Place& place) const {
    const RoomIndex room = plan_.building().find_room(place.room);
    if (room == kNoRoom) return Error{"there is no room " + place.room + " in the building"};
    if (!inside(plan_.building().room(room), place.at)) {
      return Error{"the place is not inside room " + place.room};
    }
    return room;
  }

  double level_heading() const { return wrap_angle(body_.heading + plan_.building().room(room_).frame.heading); }

  void pass_door(RoomIndex next) {
    const Doorway* nearest = nullptr;
    for (const Doorway& doorway : plan_.doorways(room_)) {
      if (doorway.other != next) continue;
      if (nearest == nullptr ||
          distance(doorway.centre, body_.position) < distance(nearest->centre, body_.position)) {
        nearest = &doorway;
      }
    }
    if (nearest != nullptr) body_ = nearest->other_frame.relative(body_);
    room_ = next;
  }

  void walk_to(Vec2 point) {
    for (;;) {
      const Vec2 ahead = point - body_.position;
      const double left = norm(ahead);
      if (left < 1e-3) return;
      const double error = wrap_angle(std::atan2(ahead.y, ahead.x) - body_.heading);
      const double willing = std::abs(error) > kStandAndTurn ? 0.0 : std::cos(error);
      tick(cruise_ * willing, error, ahead, left);
      if (time_ > kLongest) return;
    }
  }

  // One step of time: chest towards `turn` (what is left to turn), feet at most `left` along `ahead`.
  void tick(double wanted_speed, double turn, Vec2 ahead = {}, double left = 0.0) {
    constexpr double dt = Trajectory::kStep;
    const double wanted_rate = std::clamp(kTurnGain * turn, -kTurnRate, kTurnRate);
    turn_rate_ += std::clamp(wanted_rate - turn_rate_, -kTurnAcceleration * dt, kTurnAcceleration * dt);
    body_.heading = wrap_angle(body_.heading + turn_rate_ * dt);
    yaw_ += turn_rate_ * dt;

    mood_ += -mood_ * dt / kSpeedMemory + world_.speed_variation * std::sqrt(2.0 * dt / kSpeedMemory) * random_.normal();
    const double target = wanted_speed * std::max(0.3, 1.0 + mood_);
    speed_ += std::clamp(target - speed_, -2.0 * kAcceleration * dt, kAcceleration * dt);
    if (left > 0.0) {
      const double moved = std::min(left, speed_ * dt);
      body_.position = body_.position + (moved / left) * ahead;
      stride_ += kPi * moved / world_.step_length_m;
    }
    time_ += dt;
    record();
  }

  // Weaving and swaying belong to the chest that carries the belt, not to the way the feet take.
  void record() {
    const double gait = std::min(1.0, speed_ / 0.4);
    const double sway = gait * world_.yaw_sway_rad * std::sin(stride_);
    const double aside = gait * world_.side_sway_m * std::sin(stride_ + 0.6);
    Moment moment;
    moment.time_s = time_;
    moment.room = room_;
    moment.pose.heading = wrap_angle(body_.heading + sway);
    moment.pose.position = body_.position + aside * perpendicular(unit_from_angle(body_.heading));
    moment.yaw = yaw_ + sway;
    moment.speed = speed_;
    moment.stride = stride_;
    samples_.push_back(moment);
  }

  const FloorPlan& plan_;
  const World& world_;
  double cruise_;
  Random random_;
  std::vector<Moment>& samples_;
  RoomIndex room_ = kNoRoom;
  Pose2 body_{};
  double time_ = 0.0;
  double yaw_ = 0.0;
  double turn_rate_ = 0.0;
  double speed_ = 0.0;
  double mood_ = 0.0;
  double stride_ = 0.0;
};

}  // namespace

Result<Trajectory> Trajectory::follow(const FloorPlan& plan, const Walk& walk, Random random) {
  Trajectory trajectory;
  Walker walker(plan, walk, random, trajectory.samples_);
  if (Status status = walker.start(walk.start, walk.start_heading); !status.ok()) return status.error();
  for (const WalkStep& step : walk.steps) {
    if (Status status = std::visit(walker, step); !status.ok()) return status.error();
  }
  return trajectory;
}

Moment Trajectory::at(double time_s) const {
  const auto last = samples_.size() - 1;
  const double position = std::clamp(time_s / kStep, 0.0, static_cast<double>(last));
  const auto i = std::min(static_cast<std::size_t>(position), last);
  const Moment& a = samples_[i];
  const Moment& b = samples_[std::min(i + 1, last)];
  const double f = position - static_cast<double>(i);
  const bool jump = a.room != b.room || distance(a.pose.position, b.pose.position) > 0.2;
  if (jump) return f < 0.5 ? a : b;
  Moment moment = a;
  moment.time_s = time_s;
  moment.pose.position = a.pose.position + f * (b.pose.position - a.pose.position);
  moment.pose.heading = wrap_angle(a.pose.heading + f * wrap_angle(b.pose.heading - a.pose.heading));
  moment.yaw += f * (b.yaw - a.yaw);
  moment.stride += f * (b.stride - a.stride);
  moment.speed += f * (b.speed - a.speed);
  return moment;
}

}  // namespace echoway::sim
