// What it saves that a firing looks only at what its place can hear (docs/leaving-out.md): the expected echoes of the
// same particles from the place's list and from the whole room, in rooms of the project's maps.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "echoway/building/loader.hpp"
#include "echoway/geometry/box.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "echoway/random.hpp"
#include "support/whole_room.hpp"
#include "tracker/elementary.hpp"

namespace echoway {
namespace {

constexpr const char* kMaps[] = {"sample-room", "two-rooms", "torgersen-lab", "similar-rooms", "westport-house"};
constexpr int kPlaces = 60;                   // Wearers, spread over the building's rooms,
constexpr int kParticles = 100;               // each with as many particles as the tracker keeps at least,
constexpr double kSpread = 0.15;              // so far about the place, metres,
constexpr double kTurn = degrees(5.0);        // and so far off in heading,
constexpr double kSweep = kTwoPi / 15.0;      // whose belt fires once all round.

struct Crowd {
  RoomIndex room;
  std::vector<tracker::Particle> particles;
};

Vec2 somewhere_in(const Room& room, Random& random) {
  const auto [low, high] = box_about(room.boundary);
  for (;;) {
    const Vec2 at{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    if (contains(room.boundary, at)) return at;
  }
}

tracker::Particle particle(RoomIndex room, Vec2 at, double heading) {
  tracker::Particle p;
  p.room = room;
  p.position = at;
  p.heading = heading;
  tracker::face_heading(p);
  return p;
}

std::vector<Crowd> crowds_in(const Building& building) {
  Random random(11);
  std::vector<Crowd> crowds;
  for (int i = 0; i < kPlaces; ++i) {
    const auto room = static_cast<RoomIndex>(static_cast<std::size_t>(i) * building.rooms.size() / kPlaces);
    const Vec2 place = somewhere_in(building.room(room), random);
    const double heading = random.uniform(-kPi, kPi);
    Crowd crowd{room, {}};
    for (int k = 0; k < kParticles; ++k) {
      const Vec2 at = place + kSpread * Vec2{random.normal(), random.normal()};
      crowd.particles.push_back(particle(room, at, heading + kTurn * random.normal()));
    }
    crowds.push_back(std::move(crowd));
  }
  return crowds;
}

// Every particle's expected echoes for one pass of the belt, by `expect`.
template <class Expect>
void fire_all_round(const Crowd& crowd, Expect expect) {
  for (int sensor = 0; sensor < 15; ++sensor) {
    tracker::Shot shot;
    shot.radius = BeltConfig{}.radius_m;
    shot.bearing_rad = sensor * kSweep;
    shot.bearing = unit_from_angle(shot.bearing_rad);
    for (const tracker::Particle& p : crowd.particles) benchmark::DoNotOptimize(expect(p, shot).count);
  }
}

void count_expectations(benchmark::State& state) {
  state.counters["s_per_expectation"] =
      benchmark::Counter(15.0 * kPlaces * kParticles * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void fire_at_places(const std::vector<Crowd>& crowds, const tracker::EchoModel& model, scene::Scene& scene) {
  for (const Crowd& crowd : crowds) {
    fire_all_round(crowd, [&](const tracker::Particle& p, const tracker::Shot& shot) {
      return tracker::expect(p, shot, model, scene);
    });
  }
}

// By the lists of the places, which are made within the time by who comes there first, and known to who stays.
void from_the_place(benchmark::State& state, const char* map, bool stays) {
  const Result<Building> building = load_building(std::filesystem::path(ECHOWAY_MAPS_DIR) / map);
  if (!building) return state.SkipWithError(building.error().to_string().c_str());
  const tracker::EchoModel model(BeltConfig{}, {});
  const std::vector<Crowd> crowds = crowds_in(*building);
  auto scene = std::make_unique<scene::Scene>(*building, model.sight_limits());
  if (stays) fire_at_places(crowds, model, *scene);
  for (auto _ : state) {
    if (!stays) {
      state.PauseTiming();
      scene = std::make_unique<scene::Scene>(*building, model.sight_limits());
      state.ResumeTiming();
    }
    fire_at_places(crowds, model, *scene);
  }
  count_expectations(state);
}

void from_the_whole_room(benchmark::State& state, const char* map) {
  const Result<Building> building = load_building(std::filesystem::path(ECHOWAY_MAPS_DIR) / map);
  if (!building) return state.SkipWithError(building.error().to_string().c_str());
  const tracker::EchoModel model(BeltConfig{}, {});
  const scene::RoomCompiler compiler(*building, model.sight_limits().max_range, scene::kCellSize);
  const std::vector<Crowd> crowds = crowds_in(*building);
  std::vector<std::unique_ptr<test::WholeRoom>> rooms;
  for (const Crowd& crowd : crowds) rooms.push_back(std::make_unique<test::WholeRoom>(compiler.compile(crowd.room)));
  for (auto _ : state) {
    for (std::size_t i = 0; i < crowds.size(); ++i) {
      fire_all_round(crowds[i], [&](const tracker::Particle& p, const tracker::Shot& shot) {
        return rooms[i]->expect(p, shot, model);
      });
    }
  }
  count_expectations(state);
}

const bool kRegistered = [] {
  const auto named = [](const char* what, const char* map) { return std::string("left_out/") + what + "/" + map; };
  for (const char* map : kMaps) {
    benchmark::RegisterBenchmark(named("room", map).c_str(), from_the_whole_room, map)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(named("comes", map).c_str(), from_the_place, map, false)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(named("stays", map).c_str(), from_the_place, map, true)->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace echoway
