#include "echoway/sim/simulate.hpp"

#include <algorithm>

#include "belt/belt.hpp"
#include "echoway/locate/start_check.hpp"
#include "plan/floor_plan.hpp"
#include "wearer/phone.hpp"
#include "wearer/trajectory.hpp"

namespace echoway::sim {
namespace {

BeltHeader header_of(const BeltConfig& belt, const World& world) {
  BeltHeader header;
  header.sensors = belt.sensors;
  header.radius_m = belt.radius_m;
  header.beam_rad = belt.beam_rad;
  header.slot_s = belt.slot_s;
  if (world.thermometer) header.temperature_c = world.temperature_c;
  return header;
}

// What a walk made by a program may get wrong; walk files are checked line by line.
Status check(const Walk& walk) {
  const BeltConfig& belt = walk.belt;
  if (belt.sensors < 1 || belt.sensors > kMaxSensors) return Error{"the belt's number of sensors makes no sense"};
  if (!(belt.slot_s > 0.0) || !(belt.radius_m >= 0.0)) return Error{"the belt's slot or radius makes no sense"};
  if (!(walk.speed_mps > 0.0)) return Error{"the walking speed must be positive"};
  const auto known = [&belt](int sensor) { return sensor >= 0 && sensor < belt.sensors; };
  for (const WalkStep& step : walk.steps) {
    const std::vector<int>* sensors = nullptr;
    if (const auto* cover = std::get_if<Cover>(&step.action)) sensors = &cover->sensors;
    if (const auto* fault = std::get_if<SensorFault>(&step.action)) sensors = &fault->sensors;
    if (sensors != nullptr && !std::all_of(sensors->begin(), sensors->end(), known)) {
      return Error{"the belt has no such sensor", walk.file, step.line};
    }
  }
  return success();
}

std::vector<double> even_bearings(const BeltConfig& belt) {
  std::vector<double> bearings;
  for (int i = 0; i < belt.sensors; ++i) bearings.push_back(belt.bearing(i));
  return bearings;
}

Footprint footprint_of(const Trajectory& trajectory) {
  Footprint footprint;
  footprint.doors = trajectory.doors_used();
  for (const Moment& moment : trajectory.samples()) footprint.step_on(moment.room, moment.pose.position);
  return footprint;
}

}  // namespace

Result<Simulation> simulate(const Building& building, const Walk& walk, std::uint64_t seed) {
  if (Status status = check(walk); !status.ok()) return status.error();
  if (Status status = check_floors(building); !status.ok()) return status.error();
  Random random(seed);
  const FloorPlan plan(building);
  const Result<Trajectory> trajectory = Trajectory::follow(plan, walk, random.split());
  if (!trajectory.ok()) return trajectory.error();
  Simulation out;
  out.scans.belt = header_of(walk.belt, walk.world);
  out.motion = sense_motion(*trajectory, walk.world, random.split());
  Belt belt(plan, walk.belt, even_bearings(walk.belt), walk.world, footprint_of(*trajectory), random.next());
  const auto firings = static_cast<std::int64_t>(trajectory->duration() / walk.belt.slot_s) + 1;
  auto event = trajectory->events().begin();
  for (std::int64_t i = 0; i < firings; ++i) {
    const Moment moment = trajectory->at(static_cast<double>(i) * walk.belt.slot_s);
    for (; event != trajectory->events().end() && event->time_s <= moment.time_s; ++event) {
      belt.happens(*event->action, event->time_s);
    }
    out.scans.firings.push_back(belt.fire(moment, static_cast<int>(i % walk.belt.sensors), i));
    out.truth.push_back({moment.time_s, building.room(moment.room).id, moment.pose});
  }
  return out;
}

Result<Simulation> simulate(const Building& building, const Walk& walk) { return simulate(building, walk, walk.seed); }

Result<ScanLog> scan_at(const Building& building, const World& world, const Ring& ring,
                        const std::vector<TruthRow>& stands, std::uint64_t seed) {
  if (ring.bearings_rad.size() > kMaxSensors || ring.belt.sensors < 1 || ring.belt.sensors > kMaxSensors) {
    return Error{"the ring's number of sensors makes no sense"};
  }
  if (Status status = check_floors(building); !status.ok()) return status.error();
  const FloorPlan plan(building);
  std::vector<Moment> moments;
  Footprint footprint;
  for (const TruthRow& stand : stands) {
    Moment moment;
    moment.time_s = stand.time_s;
    moment.room = building.find_room(stand.room);
    moment.pose = stand.pose;
    if (moment.room == kNoRoom) return Error{"there is no room " + stand.room + " in the building", {}, stand.line};
    if (!check_start({moment.room, stand.pose.position, stand.pose.heading}, building)) {
      return Error{"the place is not inside room " + stand.room, {}, stand.line};
    }
    footprint.step_on(moment.room, moment.pose.position);
    moments.push_back(moment);
  }
  BeltConfig config = ring.belt;
  const std::vector<double> bearings = ring.bearings_rad.empty() ? even_bearings(config) : ring.bearings_rad;
  config.sensors = static_cast<int>(bearings.size());
  Belt belt(plan, config, bearings, world, std::move(footprint), Random(seed).next());
  ScanLog log;
  log.belt = header_of(config, world);
  std::int64_t index = 0;
  for (const Moment& moment : moments) {
    for (int sensor = 0; sensor < config.sensors; ++sensor) log.firings.push_back(belt.fire(moment, sensor, index++));
  }
  return log;
}

}  // namespace echoway::sim
