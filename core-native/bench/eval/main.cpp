// Measures the tracker on simulated walks through a building, or through a random office for each: a row a walk.
// scripts/tracker_figures.sh says which walks docs/tracker.md shows.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "buildings.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "rays/walk.hpp"
#include "report/context.hpp"
#include "report/following.hpp"
#include "report/table.hpp"

namespace echoway::eval {
namespace {

constexpr const char* kColumns =
    "building,start,hints,walk,firings,error_m,heading_error_deg,right_room,within_2_sigma,found_s,"
    "median_us,mean_us,worst_us";

struct Options {
  std::string building;           // Empty: a random office for every walk.
  std::string profile = "furnished";
  int walks = 16;
  int first = 1;
  int rooms = 4;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  double pace_mps = 0.5;
  double cover = 0.0;
  double teleport = 0.0;
  double seconds = 80.0;
  std::string world = "waves";
  bool no_hints = false;
  bool unknown = false;
  bool head = false;
  int particles = 0;              // 0: the tracker's own number.
};

template <class T>
T expect(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().to_string());
  return std::move(*result);
}

report::Estimator estimator_of(const Options& o) {
  report::Estimator estimator = o.no_hints ? report::tracker_without_hints() : report::tracker();
  if (o.unknown) estimator.told = report::Estimator::Told::nothing;
  if (o.particles > 0) estimator.bayes.particles = estimator.bayes.particles_without_gyroscope = o.particles;
  return estimator;
}

sim::Simulation walk_through(const Building& building, const Options& o, std::uint64_t seed) {
  sim::RandomWalkOptions walk;
  walk.speed_mps = o.pace_mps;
  walk.teleport_probability = o.teleport;
  walk.cover_probability = o.cover;
  walk.duration_s = o.seconds;
  walk.profile = *sim::profile_of(o.profile);
  const bool among_rays = o.world == "rays";
  const auto elsewhere = [&](const Room& room) { return room.level != building.rooms.front().level; };
  if (among_rays && std::ranges::any_of(building.rooms, elsewhere)) {
    throw std::runtime_error("rays know one level, no more");
  }
  sim::Simulation simulation = expect(sim::simulate(building, sim::random_walk(building, walk, seed * 101 + 7)));
  return among_rays ? rays::heard_by_rays(building, simulation, seed) : simulation;
}

// Seconds until the place was right for three seconds in a row; -1: never.
double found_after(const report::Track& track) {
  constexpr double kFoundFor = 3.0;
  double since = -1.0;
  for (const report::Fix& fix : track.fixes) {
    const bool right = fix.right() && fix.error_m < kMetresPerFoot;
    if (!right) since = -1.0;
    if (right && since < 0.0) since = fix.time_s;
    if (right && fix.time_s - since > kFoundFor) return since - track.fixes.front().time_s;
  }
  return -1.0;
}

std::string row_of(const Options& o, int number) {
  const auto seed = static_cast<std::uint64_t>(number);
  const Building building = o.building.empty() ? random_office(o.rooms, seed) : expect(load_building(o.building));
  const sim::Simulation walk = walk_through(building, o, seed);
  const report::Track track = report::follow({building, building, walk, kReferenceCelsius, seed}, estimator_of(o));
  const report::Summary s = report::summarise(track);
  report::Table row;
  row.add(o.building.empty() ? "offices" : o.building, o.unknown ? "unknown" : "known", o.no_hints ? "no" : "yes",
          number, track.fixes.size(), s.mean_m, to_degrees(s.turn_rad), s.right_room, s.within_2_sigma,
          found_after(track), report::quantile(track.firing_us, 0.5), track.cpu_us(),
          report::quantile(track.firing_us, 1.0));
  return row.text();
}

int run(const Options& o) {
  if (o.head) {
    fmt::print("{}\n", kColumns);
    return 0;
  }
  report::Context context;
  context.threads = o.threads;
  try {
    for (const std::string& row : report::run_all(context, o.walks, [&](int k) { return row_of(o, o.first + k); })) {
      std::fputs(row.c_str(), stdout);
    }
  } catch (const std::exception& problem) {
    fmt::print(stderr, "echoway_eval: {}\n", problem.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace echoway::eval

int main(int argc, char** argv) {
  echoway::eval::Options o;
  CLI::App app("The tracker on many simulated walks, a row a walk");
  app.add_option("--building", o.building, "A building's folder; a random office for each walk without")
      ->check(CLI::ExistingDirectory);
  app.add_option("--rooms", o.rooms, "Rooms on either side of a random office")
      ->check(CLI::Range(1, 200))
      ->capture_default_str();
  app.add_option("--walks", o.walks, "How many")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--first", o.first, "Number of the first; it says all about a walk")->capture_default_str();
  app.add_option("--seconds", o.seconds, "Of each, about")->check(CLI::Range(1.0, 3600.0))->capture_default_str();
  app.add_option("--speed", o.pace_mps, "m/s")->check(CLI::Range(0.1, 3.0))->capture_default_str();
  app.add_option("--profile", o.profile, "Of the simulated world")
      ->check(CLI::IsMember({"empty", "furnished", "hard"}))
      ->capture_default_str();
  app.add_option("--world", o.world, "The simulator's, of waves, or the plainer one of rays for buildings of one level")
      ->check(CLI::IsMember({"waves", "rays"}))
      ->capture_default_str();
  app.add_option("--teleport", o.teleport, "Probability of being carried off at each goal")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--cover", o.cover, "Probability that the sensors are covered at each goal")
      ->check(CLI::Range(0.0, 1.0));
  app.add_flag("--head", o.head, "Only name the columns of the rows, and leave");
  app.add_flag("--no-hints", o.no_hints, "Without the phone's motion sensors");
  app.add_flag("--unknown", o.unknown, "Without being told the start");
  app.add_option("--particles", o.particles, "The tracker's own number without")->check(CLI::Range(1, 2400));
  app.add_option("--threads", o.threads, "Walks at a time")->check(CLI::Range(1, 256))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return echoway::eval::run(o);
}
