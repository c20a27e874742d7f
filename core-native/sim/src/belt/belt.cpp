#include "belt/belt.hpp"

#include <algorithm>
#include <cmath>

#include "streams.hpp"
#include "wearer/arms.hpp"

namespace echoway::sim {
namespace {

constexpr double kGhostWithin = 4.0;  // Metres.

}  // namespace

Belt::Belt(const FloorPlan& plan, const Walk& walk, const Trajectory& trajectory, std::uint64_t seed)
    : plan_(plan),
      walk_(walk),
      seed_(seed),
      receiver_(walk.world),
      floor_(plan, trajectory, walk.world, seed),
      people_(plan, walk.world.people_per_100m2, seed),
      ballasts_(plan, walk.world.bad_ballasts, seed),
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

Firing Belt::fire(const Moment& moment, std::int64_t index) {
  const World& world = walk_.world;
  Random random = stream(seed_, Stream::firing, static_cast<std::uint64_t>(index));
  Firing firing{moment.time_s, static_cast<int>(index % walk_.belt.sensors), Firing::kNoEcho};
  std::optional<double> range = measure(moment, firing.sensor, random);
  if (random.uniform() < world.dropout) range.reset();
  if (range) *range *= 1.0 + world.range_noise * random.normal();
  if (random.uniform() < world.ghost) {
    const double ghost = random.uniform(walk_.belt.min_range_m, kGhostWithin);
    range = std::min(range.value_or(ghost), ghost);
  }
  range = faults_.apply(firing.sensor, moment.time_s, range);
  if (!range || *range < walk_.belt.min_range_m || *range > walk_.belt.max_range_m) return firing;
  const double tick = 0.5 * world.timer_tick_s * speed_of_sound(kReferenceCelsius);
  firing.range_m = tick > 0.0 ? tick * std::round(*range / tick) : *range;
  return firing;
}

std::optional<double> Belt::measure(const Moment& moment, int number, Random& random) {
  const World& world = walk_.world;
  const View& view = floor_.view_from(moment.room);
  Sensor sensor;
  sensor.axis = unit_from_angle(moment.pose.heading + walk_.belt.bearing(number));
  sensor.face = moment.pose.position + walk_.belt.radius_m * sensor.axis;
  sensor.room = view.trace(0, moment.pose.position, sensor.face);
  if (sensor.room < 0) return std::nullopt;  // Pressed against something.

  obstacles_.clear();
  add_arms(moment, world.arms, obstacles_);
  people_.add(view, moment.time_s, moment.pose.position, obstacles_);
  std::swap(previous_, arrivals_);
  find_arrivals(view, receiver_, world, sensor, obstacles_, 2.0 * walk_.belt.max_range_m, arrivals_);
  const std::vector<Arrival> own = arrivals_;
  listen_for_previous(sensor);
  for (Arrival& arrival : arrivals_) arrival.amplitude *= std::pow(10.0, world.flutter_db * random.normal() / 20.0);
  std::erase_if(arrivals_, [&](const Arrival& arrival) { return arrival.path_m < 2.0 * walk_.belt.min_range_m; });

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
  const double slot = walk_.belt.slot_s * speed_of_sound(walk_.world.temperature_c);
  for (const Arrival& late : previous_) {
    const double cosine = dot(late.from, sensor.axis);
    if (late.path_m > slot && cosine > 0.0) arrivals_.push_back({late.path_m - slot, late.amplitude, cosine, late.from});
  }
}

// Sound that went to and fro between walls until the next sensor listens.
std::optional<double> Belt::late_echo(Random& random) const {
  const bool heard = random.uniform() < walk_.world.crosstalk;
  const double more = 1.0 + std::floor(random.uniform(0.0, 2.0));
  if (!heard || previous_.empty()) return std::nullopt;
  const auto loudest = std::max_element(previous_.begin(), previous_.end(), [](const Arrival& a, const Arrival& b) {
    return std::abs(a.amplitude) < std::abs(b.amplitude);
  });
  const double slot = walk_.belt.slot_s * speed_of_sound(walk_.world.temperature_c);
  return (std::floor(slot / loudest->path_m) + more) * loudest->path_m - slot;
}

double Belt::temperature(const Moment& moment) const {
  const World& world = walk_.world;
  const Vec2 at = plan_.building().room(moment.room).frame.transform(moment.pose.position);
  const Vec2 origin = plan_.building().rooms.front().frame.position;
  return world.temperature_c + world.temperature_gradient_k_per_m * dot(at - origin, warmer_) +
         world.temperature_drift_k_per_min * moment.time_s / 60.0;
}

}  // namespace echoway::sim
