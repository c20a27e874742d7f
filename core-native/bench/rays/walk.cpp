#include "rays/walk.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "rays/world.hpp"

namespace echoway::rays {
namespace {

/// The wearer on the level, when a sensor fired.
struct Stand {
  double time_s = 0.0;
  Pose2 pose{};
};

std::vector<Stand> stands_of(const Building& building, const sim::Simulation& walk) {
  std::vector<Stand> stands;
  for (const TruthRow& row : walk.truth) {
    stands.push_back({row.time_s, building.room(building.find_room(row.room)).frame.compose(row.pose)});
  }
  return stands;
}

class Phone {
 public:
  explicit Phone(Random random)
      : random_(random),
        step_(random_.uniform(0.45, 0.8)),
        bias_(random_.uniform(degrees(-1.0), degrees(1.0))),
        walked_(random_.uniform(0.0, step_)) {}

  void feel(const Stand& before, const Stand& now) {
    count_steps(before, now);
    feel_turn(before, now);
    read_compass(now);
  }

  std::vector<MotionHint> hints() && {
    std::ranges::stable_sort(hints_, {}, &MotionHint::time_s);
    return std::move(hints_);
  }

 private:
  void count_steps(const Stand& before, const Stand& now) {
    constexpr double kMissed = 0.05, kInvented = 0.003, kLatest = 0.3;
    walked_ += distance(before.pose.position, now.pose.position);
    const bool steps = walked_ > step_;
    if (steps) walked_ -= step_;
    const bool seen = steps ? random_.uniform() > kMissed : random_.uniform() < kInvented;
    if (seen) hints_.push_back({now.time_s + random_.uniform(0.0, kLatest), MotionKind::step, 1.0});
  }

  void feel_turn(const Stand& before, const Stand& now) {
    constexpr int kReadings = 3;
    constexpr double kNoise = degrees(0.6);
    const double seconds = now.time_s - before.time_s;
    const double rate = wrap_angle(now.pose.heading - before.pose.heading) / seconds;
    for (int i = 1; i <= kReadings; ++i) {
      const double time = before.time_s + seconds * i / kReadings;
      hints_.push_back({time, MotionKind::yaw_rate, rate + bias_ + random_.normal(0.0, kNoise)});
    }
  }

  void read_compass(const Stand& now) {
    if (now.time_s < next_compass_) return;
    next_compass_ = now.time_s + 1.0;
    drift_ += random_.normal(0.0, degrees(0.2));
    const double heading = now.pose.heading + drift_ + random_.normal(0.0, degrees(3.0));
    hints_.push_back({now.time_s, MotionKind::heading, wrap_angle(heading)});
  }

  Random random_;
  double step_;                    // Metres.
  double bias_;                    // Of the gyroscope, rad/s.
  double walked_;                  // Metres since the last step.
  double drift_ = 0.0;             // Of the compass, radians.
  double next_compass_ = 0.0;
  std::vector<MotionHint> hints_;
};

ScanLog scan(const sim::Simulation& walk, const std::vector<Stand>& stands, World& world) {
  ScanLog log = walk.scans;
  const BeltConfig belt = walk.scans.belt.apply_to({});
  for (std::size_t i = 0; i < stands.size(); ++i) {
    Firing& firing = log.firings[i];
    const Pose2& pose = stands[i].pose;
    const Vec2 axis = unit_from_angle(pose.heading + belt.bearing(firing.sensor));
    const double range = world.fire(pose.position + belt.radius_m * axis, axis, belt.slot_s);
    firing.range_m = range > belt.min_range_m && range < belt.max_range_m ? range : Firing::kNoEcho;
  }
  return log;
}

}  // namespace

sim::Simulation heard_by_rays(const Building& building, const sim::Simulation& walk, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Stand> stands = stands_of(building, walk);
  std::vector<Vec2> way;
  for (const Stand& s : stands) way.push_back(s.pose.position);
  World world(furnish(building, way, random), random.split());
  Phone phone(random.split());
  for (std::size_t i = 1; i < stands.size(); ++i) phone.feel(stands[i - 1], stands[i]);
  return {scan(walk, stands, world), std::move(phone).hints(), walk.truth};
}

}  // namespace echoway::rays
