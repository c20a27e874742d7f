#include "echoway/sim/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "acoustics/echo_paths.hpp"
#include "plan/floor_plan.hpp"
#include "wearer/arms.hpp"
#include "wearer/phone.hpp"

namespace echoway::sim {
namespace {

// Where the wearer passes, room by room, so that nothing is put there.
std::map<RoomIndex, std::vector<Vec2>> footprints(const Trajectory& trajectory) {
  std::map<RoomIndex, std::vector<Vec2>> places;
  for (const Moment& moment : trajectory.samples()) {
    std::vector<Vec2>& of_room = places[moment.room];
    if (of_room.empty() || distance(of_room.back(), moment.pose.position) > 0.1) of_room.push_back(moment.pose.position);
  }
  return places;
}

class Run {
 public:
  Run(const FloorPlan& plan, const Walk& walk, const Trajectory& trajectory, Random random)
      : plan_(plan),
        walk_(walk),
        trajectory_(trajectory),
        receiver_(walk.world),
        footprints_(footprints(trajectory)),
        scene_seed_(random.next()),
        random_(random.split()),
        doorways_(plan.building().rooms.size()) {
    for (std::size_t i = 0; i < doorways_.size(); ++i) doorways_[i] = plan.doorways(static_cast<RoomIndex>(i));
  }

  Firing fire(const Moment& moment, int sensor) {
    Firing firing{moment.time_s, sensor, Firing::kNoEcho};
    std::optional<double> range = measure(moment, sensor);
    // Drawn in every slot, whether used or not: one echo more or less must not change the rest of the walk.
    const double noise = random_.normal();
    const bool lost = random_.uniform() < walk_.world.dropout;
    const bool ghost = random_.uniform() < walk_.world.ghost;
    const double ghost_at = random_.uniform(walk_.belt.min_range_m, 4.0);
    if (lost) range.reset();
    if (range) *range *= 1.0 + walk_.world.range_noise * noise;
    if (ghost && (!range || ghost_at < *range)) range = ghost_at;
    if (!range || *range < walk_.belt.min_range_m || *range > walk_.belt.max_range_m) return firing;
    firing.range_m = quantised(*range);
    return firing;
  }

 private:
  std::optional<double> measure(const Moment& moment, int sensor) {
    const World& world = walk_.world;
    const View& view = view_from(moment.room);
    Sensor transducer;
    transducer.axis = unit_from_angle(moment.pose.heading + walk_.belt.bearing(sensor));
    transducer.face = moment.pose.position + walk_.belt.radius_m * transducer.axis;
    transducer.room = view.trace(0, moment.pose.position, transducer.face);
    if (transducer.room < 0) return std::nullopt;  // Pressed against something.
    obstacles_.clear();
    add_arms(moment, world.arms, obstacles_);
    find_arrivals(view, receiver_, world, transducer, obstacles_, 2.0 * walk_.belt.max_range_m, arrivals_);
    std::erase_if(arrivals_, [&](const Arrival& arrival) { return arrival.path_m < 2.0 * walk_.belt.min_range_m; });
    const std::optional<double> path = receiver_.first_crossing(arrivals_);
    if (!path) return std::nullopt;
    // The belt turns time into range with the speed of sound at 20 degrees.
    return 0.5 * *path * speed_of_sound(kReferenceCelsius) / speed_of_sound(world.temperature_c);
  }

  double quantised(double range_m) const {
    const double tick_m = 0.5 * walk_.world.timer_tick_s * speed_of_sound(kReferenceCelsius);
    return tick_m > 0.0 ? tick_m * std::round(range_m / tick_m) : range_m;
  }

  const RoomScene& scene_of(RoomIndex room) {
    const auto known = scenes_.find(room);
    if (known != scenes_.end()) return known->second;
    Random random(scene_seed_ + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(room + 1));
    return scenes_
        .emplace(room, build_room_scene(plan_.building().room(room), plan_.doorways(room), walk_.world,
                                        footprints_[room], random.split()))
        .first->second;
  }

  const View& view_from(RoomIndex room) {
    const auto known = views_.find(room);
    if (known != views_.end()) return known->second;
    return views_
        .emplace(room, View(room, doorways_, [this](RoomIndex r) -> const RoomScene& { return scene_of(r); },
                            [](std::size_t) { return true; }))
        .first->second;
  }

  const FloorPlan& plan_;
  const Walk& walk_;
  const Trajectory& trajectory_;
  Receiver receiver_;
  std::map<RoomIndex, std::vector<Vec2>> footprints_;
  std::uint64_t scene_seed_;
  Random random_;
  std::vector<std::vector<Doorway>> doorways_;
  std::map<RoomIndex, RoomScene> scenes_;
  std::map<RoomIndex, View> views_;
  std::vector<Obstacle> obstacles_;
  std::vector<Arrival> arrivals_;
};

BeltHeader header_of(const BeltConfig& belt) {
  BeltHeader header;
  header.sensors = belt.sensors;
  header.radius_m = belt.radius_m;
  header.beam_rad = belt.beam_rad;
  header.slot_s = belt.slot_s;
  return header;
}

}  // namespace

Result<Simulation> simulate(const Building& building, const Walk& walk, std::uint64_t seed) {
  Random random(seed);
  const FloorPlan plan(building);
  Result<Trajectory> trajectory = Trajectory::follow(plan, walk, random.split());
  if (!trajectory.ok()) return trajectory.error();
  Simulation out;
  out.scans.belt = header_of(walk.belt);
  out.motion = sense_motion(*trajectory, walk.world, random.split());
  Run run(plan, walk, *trajectory, random.split());
  const auto firings = static_cast<std::int64_t>(trajectory->duration() / walk.belt.slot_s) + 1;
  for (std::int64_t k = 0; k < firings; ++k) {
    const Moment moment = trajectory->at(static_cast<double>(k) * walk.belt.slot_s);
    out.scans.firings.push_back(run.fire(moment, static_cast<int>(k % walk.belt.sensors)));
    out.scans.firings.back().time_s = static_cast<double>(k) * walk.belt.slot_s;
    out.truth.push_back({static_cast<double>(k) * walk.belt.slot_s, building.room(moment.room).id, moment.pose});
  }
  return out;
}

Result<Simulation> simulate(const Building& building, const Walk& walk) { return simulate(building, walk, walk.seed); }

}  // namespace echoway::sim
