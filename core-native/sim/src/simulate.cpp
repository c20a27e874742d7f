#include "echoway/sim/simulate.hpp"

#include "belt/belt.hpp"
#include "plan/floor_plan.hpp"
#include "wearer/phone.hpp"
#include "wearer/trajectory.hpp"

namespace echoway::sim {
namespace {

BeltHeader header_of(const Walk& walk) {
  BeltHeader header;
  header.sensors = walk.belt.sensors;
  header.radius_m = walk.belt.radius_m;
  header.beam_rad = walk.belt.beam_rad;
  header.slot_s = walk.belt.slot_s;
  if (walk.world.thermometer) header.temperature_c = walk.world.temperature_c;
  return header;
}

}  // namespace

Result<Simulation> simulate(const Building& building, const Walk& walk, std::uint64_t seed) {
  Random random(seed);
  const FloorPlan plan(building);
  const Result<Trajectory> trajectory = Trajectory::follow(plan, walk, random.split());
  if (!trajectory.ok()) return trajectory.error();
  Simulation out;
  out.scans.belt = header_of(walk);
  out.motion = sense_motion(*trajectory, walk.world, random.split());
  Belt belt(plan, walk, *trajectory, random.next());
  const auto firings = static_cast<std::int64_t>(trajectory->duration() / walk.belt.slot_s) + 1;
  auto event = trajectory->events().begin();
  for (std::int64_t i = 0; i < firings; ++i) {
    const Moment moment = trajectory->at(static_cast<double>(i) * walk.belt.slot_s);
    for (; event != trajectory->events().end() && event->time_s <= moment.time_s; ++event) {
      belt.happens(*event->action, event->time_s);
    }
    out.scans.firings.push_back(belt.fire(moment, i));
    out.truth.push_back({moment.time_s, building.room(moment.room).id, moment.pose});
  }
  return out;
}

Result<Simulation> simulate(const Building& building, const Walk& walk) { return simulate(building, walk, walk.seed); }

}  // namespace echoway::sim
