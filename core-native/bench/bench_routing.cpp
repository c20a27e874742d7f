// How fast ways are found: a first answer (tree and way) and a reroute (way along an existing tree) in a building of
// 1,000 rooms, and what a router costs to make, for many plain rooms and for one room of 500 walls.
#include <benchmark/benchmark.h>

#include <cmath>

#include "../test/support/plans.hpp"
#include "echoway/random.hpp"
#include "echoway/routing/router.hpp"
#include "office_block.hpp"

namespace echoway {
namespace {

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
  const Building b = draw_office_block(1000);
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
  const Building b = draw_office_block(1000);
  const Router router(b);
  Random random(2);
  const auto tree = router.tree_to({Goal::Kind::spot, 0, anywhere(b, random)});
  Route route;
  for (auto _ : state) benchmark::DoNotOptimize(router.route_from(anywhere(b, random), *tree, route));
}
BENCHMARK(reroute_in_1000_rooms)->Unit(benchmark::kMicrosecond);

void make_router_of_1000_rooms(benchmark::State& state) {
  const Building b = draw_office_block(1000);
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
