// What a firing costs in buildings of different size: the same walk, through offices that are in both.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstdlib>

#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "office_block.hpp"

namespace echoway {
namespace {

constexpr int kFewRooms = 51;                    // One floor.
constexpr std::uint64_t kOrdinaryWalk = 6;       // Tracked all the way: searching costs more the larger the building.

const sim::Simulation& walk_on_one_floor() {
  static const sim::Simulation walk = [] {
    sim::RandomWalkOptions options;
    options.duration_s = 60.0;
    const Building floor = load_office_block(kFewRooms);
    auto run = sim::simulate(floor, sim::random_walk(floor, options, kOrdinaryWalk));
    if (!run) std::abort();
    return std::move(*run);
  }();
  return walk;
}

void track(benchmark::State& state) {
  const sim::Simulation& walk = walk_on_one_floor();
  const Building building = load_office_block(static_cast<int>(state.range(0)));
  const TruthRow& first = walk.truth.front();
  Start start;
  start.room = building.find_room(first.room);
  start.position = first.pose.position;
  start.heading = first.pose.heading;
  std::int64_t firings = 0;
  for (auto _ : state) {
    state.PauseTiming();
    BayesLocator locator(building, walk.scans.belt.apply_to({}), start, {});
    state.ResumeTiming();
    auto hint = walk.motion.begin();
    for (const Firing& firing : walk.scans.firings) {
      for (; hint != walk.motion.end() && hint->time_s <= firing.time_s; ++hint) locator.on_motion(*hint);
      benchmark::DoNotOptimize(locator.on_firing(firing));
    }
    firings += static_cast<std::int64_t>(walk.scans.firings.size());
  }
  state.counters["s_per_firing"] =
      benchmark::Counter(static_cast<double>(firings), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(track)->Name("track_a_walk/rooms")->Arg(kFewRooms)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace echoway
