#include "echoway/sim/random_walk.hpp"

#include <algorithm>

#include "plan/floor_plan.hpp"

namespace echoway::sim {
namespace {

// Any room that has a place to stand.
RoomIndex draw_room(const Building& building, const FloorPlan& plan, Random& random) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const auto room = static_cast<RoomIndex>(random.uniform() * static_cast<double>(building.rooms.size()));
    if (plan.grid(room).random_place(random)) return room;
  }
  return 0;
}

double length_of(const std::vector<Stretch>& way, Vec2 from) {
  double length = 0.0;
  for (const Stretch& stretch : way) {
    for (std::size_t i = 0; i < stretch.points.size(); ++i) {
      if (i > 0 || &stretch == &way.front()) length += distance(from, stretch.points[i]);
      from = stretch.points[i];
    }
  }
  return length;
}

}  // namespace

Walk random_walk(const Building& building, const RandomWalkOptions& options, std::uint64_t seed) {
  Random random(seed);
  Walk walk;
  walk.seed = random.next();
  walk.speed_mps = options.speed_mps;
  walk.world = options.random_world ? random_world(options.profile, random) : make_world(options.profile);
  if (building.rooms.empty() || !check_floors(building)) return walk;

  const FloorPlan plan(building);
  const RoomIndex wanted = building.find_room(options.start_room);
  RoomIndex room = wanted != kNoRoom ? wanted : draw_room(building, plan, random);
  Vec2 here = plan.grid(room).random_place(random).value_or(Vec2{});
  walk.start = {building.room(room).id, here};
  walk.start_heading = random.uniform(-kPi, kPi);
  double spent = 0.0;
  for (int attempt = 0; spent < options.duration_s && attempt < 1000; ++attempt) {
    RoomIndex next = room;
    const std::vector<Doorway>& doors = plan.doorways(room);
    if (!doors.empty() && random.uniform() < options.leave_probability) {
      next = doors[static_cast<std::size_t>(random.uniform() * static_cast<double>(doors.size()))].other;
    }
    const std::optional<Vec2> goal = plan.grid(next).random_place(random);
    if (!goal) continue;
    const Result<std::vector<Stretch>> way = plan.route(room, here, next, *goal);
    if (!way.ok()) continue;
    walk.add(GoTo{{building.room(next).id, *goal}});
    spent += length_of(*way, here) / options.speed_mps + 1.0;
    room = next;
    here = *goal;
    if (random.uniform() < options.turn_probability) {
      walk.add(TurnBy{random.uniform(-kPi, kPi)});
      spent += 2.0;
    }
    if (random.uniform() < options.pause_probability) {
      const double seconds = random.uniform(1.0, 6.0);
      walk.add(Pause{seconds});
      spent += seconds;
    }
    if (random.uniform() < options.cover_probability) walk.add(Cover{{}, random.uniform(30.0, 60.0)});
    if (random.uniform() < options.teleport_probability) {
      room = draw_room(building, plan, random);
      here = plan.grid(room).random_place(random).value_or(here);
      walk.add(Teleport{{building.room(room).id, here}, random.uniform(-kPi, kPi)});
    }
  }
  return walk;
}

}  // namespace echoway::sim
