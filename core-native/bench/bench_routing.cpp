// How fast ways are found: a first answer (tree and way) and a reroute (way along an existing tree) in a building of
// 1,000 rooms, and what a router costs to make, for many plain rooms and for one room of 500 walls.
#include <benchmark/benchmark.h>

#include <cmath>

#include "../test/support/plans.hpp"
#include "echoway/random.hpp"
#include "echoway/routing/router.hpp"

namespace echoway {
namespace {

/// A hall with 50 offices, twenty times, stacked and joined by stairs at both ends: 1,020 rooms.
Building thousand_rooms() {
  Building b;
  for (int level = 0; level < 20; ++level) {
    const auto base = static_cast<RoomIndex>(b.rooms.size());
    Building floor = test::make_office_floor(25);
    for (Room& room : floor.rooms) {
      room.id.append("-").append(std::to_string(level));
      room.level = level;
      b.rooms.push_back(std::move(room));
    }
    for (Door door : floor.doors) {
      door.room_a += base;
      door.room_b += base;
      b.doors.push_back(door);
    }
    if (level == 0) continue;
    const RoomIndex below = base - 51;
    b.links.push_back({LevelLinkKind::stairs, below, {0.5, 1.2}, base, {0.5, 1.2}});
    b.links.push_back({LevelLinkKind::elevator, below, {99.5, 1.2}, base, {99.5, 1.2}});
  }
  return b;
}

/// A star-shaped room of 250 teeth: 500 walls, half of them about reflex corners.
Building toothed_room() {
  std::vector<Vec2> outline;
  for (int i = 0; i < 500; ++i) {
    outline.push_back((i % 2 == 0 ? 30.0 : 27.0) * unit_from_angle(kTwoPi * i / 500.0));
  }
  Building b;
  b.rooms.push_back(test::make_room("hall", outline));
  return b;
}

Spot anywhere(const Building& b, Random& random) {
  const auto room = static_cast<RoomIndex>(random.uniform(0.0, static_cast<double>(b.rooms.size())));
  return {room, {random.uniform(0.6, 3.4), random.uniform(0.6, 1.8)}};
}

void first_answer_in_1000_rooms(benchmark::State& state) {
  const Building b = thousand_rooms();
  const Router router(b);
  Random random(1);
  for (auto _ : state) {
    const Spot goal = anywhere(b, random);
    benchmark::DoNotOptimize(router.find_route(anywhere(b, random), {Goal::Kind::spot, 0, goal}));
  }
  state.counters["nodes"] = static_cast<double>(router.node_count());
}
BENCHMARK(first_answer_in_1000_rooms)->Unit(benchmark::kMillisecond);

void reroute_in_1000_rooms(benchmark::State& state) {
  const Building b = thousand_rooms();
  const Router router(b);
  Random random(2);
  const auto tree = router.tree_to({Goal::Kind::spot, 0, anywhere(b, random)});
  Route route;
  for (auto _ : state) benchmark::DoNotOptimize(router.route_from(anywhere(b, random), *tree, route));
}
BENCHMARK(reroute_in_1000_rooms)->Unit(benchmark::kMicrosecond);

void make_router_of_1000_rooms(benchmark::State& state) {
  const Building b = thousand_rooms();
  for (auto _ : state) benchmark::DoNotOptimize(Router(b).node_count());
}
BENCHMARK(make_router_of_1000_rooms)->Unit(benchmark::kMillisecond);

void make_router_of_a_room_of_500_walls(benchmark::State& state) {
  const Building b = toothed_room();
  for (auto _ : state) benchmark::DoNotOptimize(Router(b).node_count());
}
BENCHMARK(make_router_of_a_room_of_500_walls)->Unit(benchmark::kMillisecond);

void reroute_in_a_room_of_500_walls(benchmark::State& state) {
  const Building b = toothed_room();
  const Router router(b);
  const auto tree = router.tree_to({Goal::Kind::spot, 0, {0, {28.0, 0.1}}});
  Random random(3);
  Route route;
  for (auto _ : state) {
    const Vec2 towards = unit_from_angle(random.uniform(-kPi, kPi));
    const Spot from{0, random.uniform(0.0, 28.0) * towards};
    benchmark::DoNotOptimize(router.route_from(from, *tree, route));
  }
}
BENCHMARK(reroute_in_a_room_of_500_walls)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace echoway
