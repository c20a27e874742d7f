#include "belt/belt.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "streams.hpp"
#include "wearer/arms.hpp"

namespace echoway::sim {
namespace {

constexpr double kBeltThickness = 0.03;  // Metres.
constexpr double kGhostWithin = 4.0;     // Metres.

}  // namespace

Belt::Belt(const FloorPlan& plan, const BeltConfig& config, std::vector<double> bearings, const World& world,
           Footprint footprint, std::uint64_t seed)
    : plan_(plan),
      config_(config),
      bearings_(std::move(bearings)),
      world_(world),
      seed_(seed),
      receiver_(world),
      floor_(plan, std::move(footprint), world, seed),
      between_(world),
      people_(plan, world.people_per_100m2, seed),
      ballasts_(plan, world.bad_ballasts, seed),
      warmer_(unit_from_angle(stream(seed, Stream::air, 0).uniform(0.0, kTwoPi))) {}

void Belt::happens(const Action& action, double now_s) {
  const Building& building = plan_.building();
  if (const auto* cover = std::get_if<Cover>(&action)) faults_.cover(*cover, now_s);
  if (const auto* fault = std::get_if<SensorFault>(&action)) faults_.set(*fault);
  if (const auto* lights = std::get_if<SetLights>(&action)) {
    ballasts_.switch_lights(building.find_room(lights->room), lights->on);
  }
  if (const auto* set = std::get_if<SetDoor>(&action)) {
    for (const std::size_t door :
         doors_between(building, building.find_room(set->room_a), building.find_room(set->room_b))) {
      floor_.set_door(door, set->open);
    }
  }
}

Firing Belt::fire(const Moment& moment, int sensor, std::int64_t index) {
  Random random = stream(seed_, Stream::firing, static_cast<std::uint64_t>(index));
  Firing firing{moment.time_s, sensor, Firing::kNoEcho};
  std::optional<double> range = measure(moment, firing.sensor, random);
  if (random.uniform() < world_.dropout) range.reset();
  if (range) *range *= 1.0 + world_.range_noise * random.normal();
  if (random.uniform() < world_.ghost) {
    const double ghost = random.uniform(config_.min_range_m, kGhostWithin);
    range = std::min(range.value_or(ghost), ghost);
  }
  range = faults_.apply(firing.sensor, moment.time_s, range);
  if (!range || *range < config_.min_range_m || *range > config_.max_range_m) return firing;
  const double tick = 0.5 * world_.timer_tick_s * speed_of_sound(kReferenceCelsius);
  firing.range_m = tick > 0.0 ? tick * std::round(*range / tick) : *range;
  return firing;
}

std::optional<double> Belt::measure(const Moment& moment, int number, Random& random) {
  const bool between = moment.between.present;
  const View& view = between ? between_.view_from(moment.between) : floor_.view_from(moment.room);
  const Pose2& pose = moment.heard_from();
  Sensor sensor;
  sensor.axis = unit_from_angle(pose.heading + bearings_[static_cast<std::size_t>(number)]);
  sensor.face = pose.position + config_.radius_m * sensor.axis;
  sensor.wearer = pose.position;
  sensor.girth = std::max(0.0, config_.radius_m - kBeltThickness);
  sensor.room = view.trace(0, pose.position, sensor.face);
  if (sensor.room < 0) return std::nullopt;  // Pressed against something.

  obstacles_.clear();
  add_arms(moment, world_.arms, obstacles_);
  if (!between) people_.add(view, moment.time_s, pose.position, obstacles_);
  std::swap(previous_, arrivals_);
  find_arrivals(view, receiver_, world_, sensor, obstacles_, 2.0 * config_.max_range_m, arrivals_);
  const std::vector<Arrival> own = arrivals_;
  listen_for_previous(sensor);
  for (Arrival& arrival : arrivals_) arrival.amplitude *= std::pow(10.0, world_.flutter_db * random.normal() / 20.0);
  std::erase_if(arrivals_, [&](const Arrival& arrival) { return arrival.path_m < 2.0 * config_.min_range_m; });

  std::optional<double> path = receiver_.first_crossing(arrivals_);
  const auto nearer = [&path](std::optional<double> other) {
    if (other && (!path || *other < *path)) path = other;
  };
  nearer(receiver_.interference_crossing(ballasts_.level(moment.room, sensor.face, sensor.axis, random.normal())));
  nearer(late_echo(random));
  arrivals_ = own;
  if (!path) return std::nullopt;
  // The belt turns time into range with the speed of sound at 20 degrees.
  return 0.5 * *path * speed_of_sound(kReferenceCelsius) / speed_of_sound(temperature(moment));
}

// With slots shorter than the longest echo, the firing before is still being answered.
void Belt::listen_for_previous(const Sensor& sensor) {
  const double slot = config_.slot_s * speed_of_sound(world_.temperature_c);
  for (const Arrival& late : previous_) {
    const double cosine = dot(late.from, sensor.axis);
    if (late.path_m > slot && cosine > 0.0)
      arrivals_.push_back({late.path_m - slot, late.amplitude, cosine, late.from});
  }
}

// Sound that went to and fro between walls until the next sensor listens.
std::optional<double> Belt::late_echo(Random& random) const {
  const bool heard = random.uniform() < world_.crosstalk;
  const double more = 1.0 + std::floor(random.uniform(0.0, 2.0));
  if (!heard || previous_.empty()) return std::nullopt;
  const auto loudest = std::max_element(previous_.begin(), previous_.end(), [](const Arrival& a, const Arrival& b) {
    return std::abs(a.amplitude) < std::abs(b.amplitude);
  });
  const double slot = config_.slot_s * speed_of_sound(world_.temperature_c);
  const double path = (std::floor(slot / loudest->path_m) + more) * loudest->path_m - slot;
  return path < 2.0 * config_.min_range_m ? std::nullopt : std::optional(path);
}

double Belt::temperature(const Moment& moment) const {
  const Vec2 at = plan_.building().room(moment.room).frame.transform(moment.pose.position);
  const Vec2 origin = plan_.building().rooms.front().frame.position;
  return world_.temperature_c + world_.temperature_gradient_k_per_m * dot(at - origin, warmer_) +
         world_.temperature_drift_k_per_min * moment.time_s / 60.0;
}

}  // namespace echoway::sim
