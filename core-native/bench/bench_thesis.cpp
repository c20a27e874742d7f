// The thesis's match of one room (it took 40 s there): time, candidates and rays per second.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "echoway/building/loader.hpp"
#include "thesis/pose_matcher.hpp"

namespace echoway::thesis {
namespace {

struct Case {
  Building building;
  RoomIndex room = 0;
  Vec2 at{};
};

// The middle of a room, or the nearest place on a spiral about it that lies on its floor.
Vec2 somewhere_inside(const Floor& floor) {
  const Vec2 middle = 0.5 * (floor.low() + floor.high());
  Vec2 at = middle;
  for (int i = 1; !floor.contains(at) && i < 1000; ++i) at = middle + 0.02 * i * unit_from_angle(0.7 * i);
  return at;
}

void match_room(benchmark::State& state, const std::string& map, const std::string& id, double beam_degrees) {
  const auto building = load_building(std::filesystem::path(ECHOWAY_MAPS_DIR) / map);
  if (!building) {
    state.SkipWithError(building.error().to_string().c_str());
    return;
  }
  const RoomIndex room = building->find_room(id);
  BeltConfig belt;
  belt.beam_rad = degrees(beam_degrees);
  const ThesisParameters parameters;
  const PoseMatcher matcher(building->room(room), openings_of(*building, room), belt, DetectionTable(belt), parameters);
  MatchWorkspace workspace(belt, parameters);

  // What the belt reads in the middle of the room; the search starts a foot and ten degrees off.
  const Pose2 pose{somewhere_inside(matcher.floor()), degrees(33.0)};
  ScanAssembler assembler(belt, parameters);
  for (int i = 0; i < 2 * belt.sensors; ++i) {
    const int sensor = i % belt.sensors;
    assembler.add({i * belt.slot_s, sensor, matcher.model().predict(pose, sensor).range_m});
  }
  Bounds bounds;
  bounds.centre = pose.position + Vec2{feet(0.7), feet(-0.7)};
  bounds.radius = parameters.movement_m;
  bounds.heading = pose.heading + degrees(10.0);
  bounds.half_turn = parameters.rotation_rad;
  double candidates = 0.0;
  for (auto _ : state) {
    const Match match = matcher.match(assembler.scan(), bounds, workspace);
    benchmark::DoNotOptimize(match);
    candidates += match.candidates;
  }
  using benchmark::Counter;
  state.counters["candidates"] = Counter(candidates, Counter::kAvgIterations);
  state.counters["candidates/s"] = Counter(candidates, Counter::kIsRate);
  state.counters["rays/s"] = Counter(candidates * belt.sensors, Counter::kIsRate);
}

BENCHMARK_CAPTURE(match_room, sample_room, "sample-room", "sample", 15.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(match_room, sample_room_wide_beam, "sample-room", "sample", 55.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(match_room, lab_with_benches, "torgersen-lab", "3", 15.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(match_room, hall, "torgersen-lab", "hall", 15.0)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace echoway::thesis
