// A real building of seven levels and 277 rooms: what it costs to load it and to take one firing in it.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "echoway/building/loader.hpp"
#include "echoway/session.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/sim/walk_file.hpp"

namespace echoway {
namespace {

const std::filesystem::path kWestport = std::filesystem::path(ECHOWAY_MAPS_DIR) / "westport-house";

void load_westport_house(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(load_building(kWestport).ok());
}
BENCHMARK(load_westport_house)->Unit(benchmark::kMillisecond);

// The same with everything that a wearer needs: tracker, routes, guidance.
void open_session_in_westport_house(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(Session::open(kWestport, {}).ok());
}
BENCHMARK(open_session_in_westport_house)->Unit(benchmark::kMillisecond);

// Along the second floor, told the start, led to a place.
void firing_in_westport_house(benchmark::State& state) {
  const Result<sim::Walk> walk = sim::read_walk(kWestport / "walks" / "second-floor.walk");
  const Result<Building> building = load_building(kWestport);
  if (!walk || !building) return state.SkipWithError("no walk");
  const Result<sim::Simulation> run = sim::simulate(*building, *walk);
  if (!run) return state.SkipWithError("the walk cannot be walked");
  SessionConfig config;
  config.start = {building->find_room(walk->start.room), walk->start.at, walk->start_heading};
  std::int64_t firings = 0;
  for (auto _ : state) {
    state.PauseTiming();
    auto session = Session::open(*building, config);
    if (!session || !(*session)->set_destination("WRLD Office")) return state.SkipWithError("no session");
    state.ResumeTiming();
    auto hint = run->motion.begin();
    for (const Firing& firing : run->scans.firings) {
      for (; hint != run->motion.end() && hint->time_s <= firing.time_s; ++hint) (*session)->on_motion(*hint);
      benchmark::DoNotOptimize((*session)->on_firing(firing));
    }
    firings += static_cast<std::int64_t>(run->scans.firings.size());
  }
  state.SetItemsProcessed(firings);
  state.counters["s_per_firing"] =
      benchmark::Counter(static_cast<double>(firings), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(firing_in_westport_house)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace echoway
