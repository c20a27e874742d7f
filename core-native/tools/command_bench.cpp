#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "commands.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/io/atomic_file.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/thesis/thesis_locator.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "scan_floor.hpp"
#include "score.hpp"
#include "session_options.hpp"

namespace echoway::tools {
namespace {

struct BenchOptions {
  std::string building;
  int walks = 8;
  double seconds = 60.0;
  std::string csv;
};

/// One estimator with one budget.
struct Contestant {
  std::string method;
  bool hints = false;
  int particles = 0;  // 0: the method has none
};

struct Outcome {
  Contestant contestant;
  double mean_m = 0.0;
  double worst_walk_m = 0.0;
  double right_room = 0.0;
  double heading_rad = 0.0;
  double cpu_us = 0.0;  // a firing
};

std::vector<Contestant> contestants() {
  const BayesOptions defaults;   // Which must be in the sweep.
  const std::set<int> with_hints{10, 20, 40, 70, 150, 240, 480, defaults.particles};
  const std::set<int> without{50, 100, 200, 400, 800, 1600, defaults.particles_without_gyroscope};
  std::vector<Contestant> all;
  for (const int particles : with_hints) all.push_back({"bayes", true, particles});
  for (const int particles : without) all.push_back({"bayes", false, particles});
  all.push_back({"thesis", false, 0});
  return all;
}

Result<std::unique_ptr<Locator>> make(const Contestant& contestant, const Building& building, const BeltConfig& belt,
                                      const Start& start) {
  if (contestant.method == "thesis") return make_thesis_locator(building, belt, start);
  BayesOptions options;
  options.particles = contestant.particles;
  options.particles_without_gyroscope = contestant.particles;
  return std::unique_ptr<Locator>(std::make_unique<BayesLocator>(building, belt, start, options));
}

Start start_of(const sim::Simulation& walk, const Building& building) {
  const TruthRow& first = walk.truth.front();
  return {building.find_room(first.room), first.pose.position, first.pose.heading};
}

/// Follows one walk; the track, and the processor's time for it in seconds.
double follow(Locator& locator, const Building& building, const sim::Simulation& walk, bool hints,
              std::vector<TrackRow>& track) {
  std::size_t next = 0;
  const std::clock_t begin = std::clock();
  for (const Firing& firing : walk.scans.firings) {
    while (hints && next < walk.motion.size() && walk.motion[next].time_s <= firing.time_s) {
      locator.on_motion(walk.motion[next++]);
    }
    if (!locator.on_firing(firing) || locator.estimate().room == kNoRoom) continue;
    const Estimate& e = locator.estimate();
    track.push_back({{e.time_s, building.room(e.room).id, e.pose}, e.sigma_m, e.room_probability, e.state});
  }
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

Result<Outcome> contest(const Contestant& contestant, const Building& building,
                        const std::vector<sim::Simulation>& walks) {
  Outcome outcome{contestant};
  double cpu_s = 0.0;
  std::size_t firings = 0;
  for (const sim::Simulation& walk : walks) {
    auto locator = make(contestant, building, walk.scans.belt.apply_to({}), start_of(walk, building));
    if (!locator) return locator.error();
    std::vector<TrackRow> track;
    cpu_s += follow(**locator, building, walk, contestant.hints, track);
    firings += walk.scans.firings.size();
    const Result<Score> score = score_track(track, walk.truth, building);
    if (!score) return score.error();
    const double share = 1.0 / static_cast<double>(walks.size());
    outcome.mean_m += share * score->mean_error_m;
    outcome.worst_walk_m = std::max(outcome.worst_walk_m, score->mean_error_m);
    outcome.right_room += share * score->right_room_share;
    outcome.heading_rad += share * score->mean_heading_error_rad;
  }
  outcome.cpu_us = 1e6 * cpu_s / static_cast<double>(firings);
  return outcome;
}

Result<std::vector<sim::Simulation>> make_walks(const Building& building, const BenchOptions& options) {
  std::vector<sim::Simulation> walks;
  for (int seed = 1; seed <= options.walks; ++seed) {
    sim::RandomWalkOptions plan;
    plan.duration_s = options.seconds;
    const auto walk_seed = static_cast<std::uint64_t>(seed);
    Result<sim::Simulation> walk = sim::simulate(building, sim::random_walk(building, plan, walk_seed), walk_seed);
    if (!walk) return walk.error();
    walks.push_back(std::move(*walk));
  }
  return walks;
}

/// The median over all walks, one stand in fifteen firings.
double median_floor(const Building& building, const std::vector<sim::Simulation>& walks) {
  constexpr std::size_t kEvery = 15;
  std::vector<TruthRow> stands;
  for (const sim::Simulation& walk : walks) {
    for (std::size_t i = 0; i < walk.truth.size(); i += kEvery) stands.push_back(walk.truth[i]);
  }
  std::vector<double> floors = scan_floors(building, {}, stands);
  if (floors.empty()) return 0.0;
  const auto middle = floors.begin() + static_cast<std::ptrdiff_t>(floors.size() / 2);
  std::nth_element(floors.begin(), middle, floors.end());
  return *middle;
}

std::string csv_row(const Outcome& o) {
  return fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.2f},{:.2f}\n", o.contestant.method, o.contestant.hints ? 1 : 0,
                     o.contestant.particles, o.mean_m, o.worst_walk_m, o.right_room, to_degrees(o.heading_rad), o.cpu_us);
}

int bench(const BenchOptions& options) {
  const Result<Building> building = load_building(options.building);
  if (!building) return bad_input(building.error());
  const Result<std::vector<sim::Simulation>> walks = make_walks(*building, options);
  if (!walks) return bad_input(walks.error());

  const double floor = median_floor(*building, *walks);
  const BayesOptions defaults;
  std::string csv = fmt::format("# one_scan_floor_m {:.4f} default_particles {} without_hints {}\n", floor,
                                defaults.particles, defaults.particles_without_gyroscope) +
                    "method,hints,particles,mean_m,worst_walk_m,right_room,heading_deg,cpu_us_a_firing\n";
  fmt::print("{} walks of about {:.0f} s; Cramer-Rao floor of one scan {:.3f} m (median)\n", options.walks,
             options.seconds, floor);
  fmt::print("{:8} {:>6} {:>10} {:>9} {:>12} {:>11} {:>9} {:>13}\n", "method", "hints", "particles", "mean, m",
             "worst walk, m", "right room", "heading", "us a firing");
  for (const Contestant& contestant : contestants()) {
    const Result<Outcome> o = contest(contestant, *building, *walks);
    if (!o) return bad_input(o.error());
    fmt::print("{:8} {:>6} {:>10} {:>9.3f} {:>13.3f} {:>9.1f} % {:>5.1f} deg {:>13.1f}\n", contestant.method,
               contestant.hints ? "yes" : "no", contestant.particles, o->mean_m, o->worst_walk_m, 100.0 * o->right_room,
               to_degrees(o->heading_rad), o->cpu_us);
    csv += csv_row(*o);
  }
  if (options.csv.empty()) return 0;
  Result<AtomicFile> file = AtomicFile::create(options.csv);
  if (!file) return bad_input(file.error());
  file->write(csv);
  const Status written = file->commit();
  return written ? 0 : bad_input(written.error());
}

}  // namespace

void add_bench(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("bench", "Error against run time: tracker and thesis's method on the same walks");
  auto options = std::make_shared<BenchOptions>();
  command->add_option("--building", options->building, "Building folder")->required();
  command->add_option("--walks", options->walks, "Random walks, seeds 1 ...")->check(CLI::Range(1, 1000))->capture_default_str();
  command->add_option("--seconds", options->seconds, "Length of a walk")->check(CLI::Range(5.0, 3600.0))->capture_default_str();
  command->add_option("--csv", options->csv, "Table to write");
  command->callback([options, &status] { status = bench(*options); });
}

}  // namespace echoway::tools
