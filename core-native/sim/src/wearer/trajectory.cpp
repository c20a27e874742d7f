#include "wearer/trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "echoway/geometry/inclusion.hpp"

namespace echoway::sim {
namespace {

constexpr double kTurnRate = degrees(100.0);  // Fastest turn of a chest, rad/s.
constexpr double kTurnAcceleration = degrees(400.0);
constexpr double kTurnGain = 4.0;                // 1/s: how eagerly the chest follows the way ahead.
constexpr double kStandAndTurn = degrees(50.0);  // Beyond this the wearer stops to turn.
constexpr double kTurnPerStep = degrees(50.0);   // Of a wearer who turns on the spot.
constexpr double kAcceleration = 0.8;            // m/s^2
constexpr double kSpeedMemory = 4.0;             // s, correlation time of slow speed changes.
constexpr double kCabinComes = 8.0;              // s before an elevator's door,
constexpr double kCabinDoor = 3.0;               // until it has shut or opened,
constexpr double kCabinStorey = 3.0;             // and a storey.
constexpr double kLongest = 3.0 * 3600.0;  // s; a longer walk is a slip of the pen, and fills the memory.

}  // namespace

double gait_of(double speed) noexcept { return std::min(1.0, speed / 0.4); }

// Moves the wearer in small steps of time and keeps what happened.
class Walker {
 public:
  Walker(const FloorPlan& plan, const Walk& walk, Random random, Trajectory& trajectory)
      : plan_(plan), world_(walk.world), cruise_(walk.speed_mps), random_(random), trajectory_(trajectory) {}

  Status start(const Place& place, double heading) {
    const Result<RoomIndex> room = find(place);
    if (!room.ok()) return room.error();
    room_ = *room;
    body_ = {place.at, heading};
    yaw_ = wrap_angle(heading + frame_heading(room_));
    record();
    return success();
  }

  Status take(const Action& action) {
    action_ = &action;
    Status status = std::visit(*this, action);
    if (status.ok() && time_ > kLongest) return Error{"the walk takes more than three hours"};
    return status;
  }

  Status operator()(const GoTo& step) {
    const Result<RoomIndex> room = find(step.to);
    if (!room.ok()) return room.error();
    const Result<std::vector<Stretch>> way = plan_.route(room_, body_.position, *room, step.to.at, shut_);
    if (!way.ok()) return way.error();
    for (const Stretch& stretch : *way) {
      for (const Vec2 point : stretch.points) walk_to(point);
      if (stretch.exit.to != kNoRoom) pass(stretch.exit);
    }
    return success();
  }
  Status operator()(const Pause& step) {
    stand(step.seconds);
    return success();
  }
  Status operator()(const TurnBy& step) {
    turn(step.angle);
    return success();
  }
  Status operator()(const Face& step) {
    turn(wrap_angle(step.heading - body_.heading));
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
  Status operator()(const Cover&) { return happens(); }
  Status operator()(const SensorFault&) { return happens(); }
  Status operator()(const SetLights& step) {
    const Result<RoomIndex> room = find(step.room);
    return room.ok() ? happens() : Status(room.error());
  }
  Status operator()(const SetDoor& step) {
    const Result<RoomIndex> a = find(step.room_a);
    if (!a.ok()) return a.error();
    const Result<RoomIndex> b = find(step.room_b);
    if (!b.ok()) return b.error();
    const std::vector<std::size_t> doors = doors_between(plan_.building(), *a, *b);
    if (doors.empty()) return Error{"no door joins rooms " + step.room_a + " and " + step.room_b};
    for (const std::size_t door : doors) {
      trajectory_.doors_used_.insert(door);
      if (step.open) {
        shut_.erase(door);
      } else {
        shut_.insert(door);
      }
    }
    return happens();
  }

 private:
  Result<RoomIndex> find(const std::string& id) const {
    const RoomIndex room = plan_.building().find_room(id);
    if (room == kNoRoom) return Error{"there is no room " + id + " in the building"};
    return room;
  }
  Result<RoomIndex> find(const Place& place) const {
    Result<RoomIndex> room = find(place.room);
    if (room.ok() && !contains(plan_.building().room(*room).boundary, place.at)) {
      return Error{"the place is not inside room " + place.room};
    }
    return room;
  }

  double frame_heading(RoomIndex room) const { return plan_.building().room(room).frame.heading; }

  Status happens() {
    trajectory_.events_.push_back({time_, action_});
    return success();
  }

  void pass(const Passage& passage) {
    if (passage.doorway >= 0) {
      const Doorway& doorway = plan_.doorways(room_)[static_cast<std::size_t>(passage.doorway)];
      body_ = doorway.other_frame.relative(body_);
      trajectory_.doors_used_.insert(doorway.door);
    } else {
      const LevelLink& link = plan_.building().links[static_cast<std::size_t>(passage.link)];
      change_level(link, passage);
    }
    room_ = passage.to;
  }

  void change_level(const LevelLink& link, const Passage& passage) {
    const int levels = plan_.building().room(passage.to).level - plan_.building().room(room_).level;
    const int storeys = std::max(1, std::abs(levels));
    const double turn = frame_heading(room_) - frame_heading(passage.to);
    ends_ = {{{room_, body_}, {passage.to, {passage.arrive_at, body_.heading + turn}}}};
    speed_ = turn_rate_ = 0.0;
    between_.kind = link.kind;
    between_.hand = passage.link % 2 == 0 ? 1 : -1;
    if (link.kind == LevelLinkKind::stairs) {
      climb(levels >= 0, storeys);
    } else {
      ride(storeys);
    }
    const double heading = ends_[1].pose.heading + body_.heading;
    between_.present = false;
    body_ = {passage.arrive_at, wrap_angle(heading)};
  }

  // Up or down, two flights a storey; over a landing into the next two.
  void climb(bool up, int storeys) {
    body_ = {stairs::path(up, between_.hand).front(), 0.0};
    between_.present = true;
    const double cruise = cruise_;
    for (int storey = 0; storey < storeys; ++storey) {
      end_ = 2 * storey >= storeys ? 1 : 0;
      if (storey > 0) {
        for (const Vec2 point : stairs::landing(up, between_.hand)) walk_to(point);
      }
      for (const Vec2 point : stairs::path(up, between_.hand)) {
        const bool flight = stairs::on_flight(0.5 * (body_.position + point));
        if (!flight && storeys == 1 && point.x > stairs::kRun) end_ = 1;
        cruise_ = flight ? std::min(cruise, stairs::kCadence * stairs::kGoing) : cruise;
        step_length_ = flight ? stairs::kGoing : world_.step_length_m;
        walk_to(point);
      }
    }
    cruise_ = cruise;
    step_length_ = world_.step_length_m;
  }

  // Waits, steps in, turns round to the door and is carried.
  void ride(int storeys) {
    stand(kCabinComes);
    body_ = {};
    between_.present = true;
    end_ = 0;
    turn(kPi);
    stand(kCabinDoor + 0.5 * kCabinStorey * storeys);
    end_ = 1;
    stand(kCabinDoor + 0.5 * kCabinStorey * storeys);
  }

  void stand(double seconds) {
    const double until = std::min(time_ + seconds, kLongest + 1.0);
    while (time_ < until) tick(0.0, 0.0);
  }

  void turn(double angle) {
    const double goal = yaw_ + angle;
    while (std::abs(goal - yaw_) > degrees(1.0) || std::abs(turn_rate_) > degrees(5.0)) tick(0.0, goal - yaw_);
  }

  void walk_to(Vec2 point) {
    while (time_ <= kLongest) {
      const Vec2 ahead = point - body_.position;
      const double left = norm(ahead);
      if (left < 1e-3) return;
      const double error = wrap_angle(std::atan2(ahead.y, ahead.x) - body_.heading);
      const double willing = std::abs(error) > kStandAndTurn ? 0.0 : std::cos(error);
      tick(cruise_ * willing, error, ahead, left);
    }
  }

  // One step of time: chest towards `turn` (what is left to turn), feet at most `left` along `ahead`.
  void tick(double wanted_speed, double to_turn, Vec2 ahead = {}, double left = 0.0) {
    constexpr double dt = Trajectory::kStep;
    const double wanted_rate = std::clamp(kTurnGain * to_turn, -kTurnRate, kTurnRate);
    turn_rate_ += std::clamp(wanted_rate - turn_rate_, -kTurnAcceleration * dt, kTurnAcceleration * dt);
    body_.heading = wrap_angle(body_.heading + turn_rate_ * dt);
    yaw_ += turn_rate_ * dt;

    mood_ +=
        -mood_ * dt / kSpeedMemory + world_.speed_variation * std::sqrt(2.0 * dt / kSpeedMemory) * random_.normal();
    const double target = wanted_speed * std::max(0.3, 1.0 + mood_);
    speed_ += std::clamp(target - speed_, -2.0 * kAcceleration * dt, kAcceleration * dt);
    double moved = 0.0;
    if (left > 0.0) {
      moved = std::min(left, speed_ * dt);
      body_.position = body_.position + (moved / left) * ahead;
    }
    // Feet that turn on the spot step as well, and the step detector cannot tell.
    stride_ += std::max(kPi * moved / step_length_, kPi * std::abs(turn_rate_) * dt / kTurnPerStep);
    time_ += dt;
    record();
  }

  // Weaving and swaying belong to the chest that carries the belt, not to the way the feet take.
  void record() {
    const double gait = gait_of(speed_);
    const double sway = gait * world_.yaw_sway_rad * std::sin(stride_);
    const double aside = gait * world_.side_sway_m * std::sin(stride_ + 0.6);
    const Pose2 chest{body_.position + aside * perpendicular(unit_from_angle(body_.heading)),
                      wrap_angle(body_.heading + sway)};
    Moment moment;
    moment.time_s = time_;
    moment.room = room_;
    moment.pose = chest;
    if (between_.present) {
      const LinkEnd& end = ends_[end_];
      moment.room = end.room;
      moment.pose = {end.pose.position, wrap_angle(end.pose.heading + chest.heading)};
      moment.between = between_;
      moment.between.pose = chest;
    }
    moment.yaw = yaw_ + sway;
    moment.heading = wrap_angle(moment.pose.heading + frame_heading(moment.room));
    moment.speed = speed_;
    moment.stride = stride_;
    trajectory_.samples_.push_back(moment);
  }

  const FloorPlan& plan_;
  const World& world_;
  double cruise_;
  Random random_;
  Trajectory& trajectory_;
  std::set<std::size_t> shut_;
  const Action* action_ = nullptr;
  RoomIndex room_ = kNoRoom;
  Pose2 body_{};  // In the room's frame; between levels in that of the stairs or the cabin.
  double step_length_ = world_.step_length_m;
  // Of stairs or an elevator: where it is left and where it leads, with the heading that its own frame has there.
  struct LinkEnd {
    RoomIndex room = kNoRoom;
    Pose2 pose{};
  };
  std::array<LinkEnd, 2> ends_{};
  std::size_t end_ = 0;
  BetweenLevels between_{};
  double time_ = 0.0;
  double yaw_ = 0.0;
  double turn_rate_ = 0.0;
  double speed_ = 0.0;
  double mood_ = 0.0;
  double stride_ = 0.0;
};

Result<Trajectory> Trajectory::follow(const FloorPlan& plan, const Walk& walk, Random random) {
  Trajectory trajectory;
  Walker walker(plan, walk, random, trajectory);
  const auto at = [&walk](const Status& status, int line) {
    return Error{status.error().message, walk.file, walk.file.empty() ? 0 : line};
  };
  if (Status status = walker.start(walk.start, walk.start_heading); !status.ok()) return at(status, walk.start_line);
  for (const WalkStep& step : walk.steps) {
    if (Status status = walker.take(step.action); !status.ok()) return at(status, step.line);
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
  const bool jump = a.room != b.room || distance(a.pose.position, b.pose.position) > 0.1 ||
                    a.between.present != b.between.present ||
                    distance(a.between.pose.position, b.between.pose.position) > 0.1;
  Moment moment = jump && f >= 0.5 ? b : a;
  moment.time_s = time_s;
  if (jump) return moment;
  moment.pose.position = a.pose.position + f * (b.pose.position - a.pose.position);
  moment.pose.heading = wrap_angle(a.pose.heading + f * wrap_angle(b.pose.heading - a.pose.heading));
  moment.between.pose.position =
      a.between.pose.position + f * (b.between.pose.position - a.between.pose.position);
  moment.between.pose.heading =
      wrap_angle(a.between.pose.heading + f * wrap_angle(b.between.pose.heading - a.between.pose.heading));
  moment.yaw += f * (b.yaw - a.yaw);
  moment.heading = wrap_angle(a.heading + f * wrap_angle(b.heading - a.heading));
  moment.stride += f * (b.stride - a.stride);
  moment.speed += f * (b.speed - a.speed);
  return moment;
}

std::vector<std::size_t> doors_between(const Building& building, RoomIndex a, RoomIndex b) {
  std::vector<std::size_t> doors;
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const Door& door = building.doors[i];
    const bool joins = (door.room_a == a && door.room_b == b) || (door.room_a == b && door.room_b == a);
    if (joins) doors.push_back(i);
  }
  return doors;
}

}  // namespace echoway::sim
