#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/io/atomic_file.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "option_checks.hpp"
#include "report/following.hpp"
#include "report/table.hpp"
#include "scan_floor.hpp"

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
  double mean_m = 0.0;
  double worst_walk_m = 0.0;
  double right_room = 0.0;
  double heading_rad = 0.0;
  double cpu_us = 0.0;     // a firing, in the mean;
  double median_us = 0.0;  // half of them cost less
};

std::vector<Contestant> contestants() {
  const BayesOptions defaults;   // Which must be in the sweep.
  const std::set<int> with_hints{10, 20, 40, 60, 120, 240, 480, defaults.particles};
  const std::set<int> without{50, 100, 200, 400, 800, 1600, defaults.particles_without_gyroscope};
  std::vector<Contestant> all;
  for (const int particles : with_hints) all.push_back({"bayes", true, particles});
  for (const int particles : without) all.push_back({"bayes", false, particles});
  all.push_back({"thesis", false, 0});
  return all;
}

report::Estimator estimator_of(const Contestant& contestant) {
  if (contestant.method == "thesis") return report::thesis_method();
  report::Estimator estimator = contestant.hints ? report::tracker() : report::tracker_without_hints();
  estimator.bayes.particles = estimator.bayes.particles_without_gyroscope = contestant.particles;
  return estimator;
}

Outcome contest(const Contestant& contestant, const Building& building, const std::vector<sim::Simulation>& walks) {
  const report::Estimator estimator = estimator_of(contestant);
  Outcome outcome;
  report::Track all;
  for (const sim::Simulation& walk : walks) {
    const report::Track track = report::follow({building, building, walk}, estimator);
    const report::Summary summary = report::summarise(track);
    const double share = 1.0 / static_cast<double>(walks.size());
    outcome.mean_m += share * summary.mean_m;
    outcome.worst_walk_m = std::max(outcome.worst_walk_m, summary.mean_m);
    outcome.right_room += share * summary.right_room;
    outcome.heading_rad += share * summary.turn_rad;
    all.firing_us.insert(all.firing_us.end(), track.firing_us.begin(), track.firing_us.end());
  }
  outcome.cpu_us = all.cpu_us();
  outcome.median_us = report::quantile(all.firing_us, 0.5);
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
  const std::vector<double> floors = scan_floors(building, {}, stands);
  return floors.empty() ? 0.0 : report::quantile(floors, 0.5);
}

int bench(const BenchOptions& options) {
  const Result<Building> building = load_building(options.building);
  if (!building) return bad_input(building.error());
  const Result<std::vector<sim::Simulation>> walks = make_walks(*building, options);
  if (!walks) return bad_input(walks.error());

  // Before the long run: what cannot be written is said at once.
  std::optional<AtomicFile> csv;
  if (!options.csv.empty()) {
    Result<AtomicFile> file = AtomicFile::create(options.csv);
    if (!file) return bad_input(file.error());
    csv = std::move(*file);
  }
  const double floor = median_floor(*building, *walks);
  report::Table table(
      "method,hints,particles,mean_m,worst_walk_m,right_room,heading_deg,cpu_us_a_firing,median_us_a_firing");
  std::FILE* const out = words_beside({options.csv});
  fmt::print(out, "{} walks of about {:.0f} s; Cramer-Rao floor of one scan {:.3f} m (median)\n", options.walks,
             options.seconds, floor);
  fmt::print(out, "{:8} {:>6} {:>10} {:>9} {:>12} {:>11} {:>9} {:>13} {:>8}\n", "method", "hints", "particles",
             "mean, m", "worst walk, m", "right room", "heading", "us a firing", "median");
  for (const Contestant& c : contestants()) {
    const Outcome o = contest(c, *building, *walks);
    fmt::print(out, "{:8} {:>6} {:>10} {:>9.3f} {:>13.3f} {:>9.1f} % {:>5.1f} deg {:>13.1f} {:>8.1f}\n", c.method,
               c.hints ? "yes" : "no", c.particles, o.mean_m, o.worst_walk_m, 100.0 * o.right_room,
               to_degrees(o.heading_rad), o.cpu_us, o.median_us);
    using report::fixed;
    table.add(c.method, c.hints ? 1 : 0, c.particles, fixed(o.mean_m, 4), fixed(o.worst_walk_m, 4),
              fixed(o.right_room, 4), fixed(to_degrees(o.heading_rad), 2), fixed(o.cpu_us, 2), fixed(o.median_us, 2));
  }
  if (!csv) return kDone;
  const BayesOptions defaults;
  csv->write(fmt::format("# one_scan_floor_m {:.4f} default_particles {} without_hints {}\n", floor, defaults.particles,
                         defaults.particles_without_gyroscope) +
             table.text());
  const Status written = csv->commit();
  return written ? kDone : bad_input(written.error());
}

}  // namespace

void add_bench(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("bench", "Error against run time: tracker and thesis's method on the same walks");
  auto options = std::make_shared<BenchOptions>();
  command->add_option("--building", options->building, "Building folder")->required()->check(not_empty());
  command->add_option("--walks", options->walks, "Random walks, seeds 1 ...")
      ->check(whole(1, 1000))
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "Length of a walk")
      ->check(decimal(5.0, 3600.0))
      ->capture_default_str();
  command->add_option("--csv", options->csv, "Table to write")->check(not_empty());
  command->callback([options, &status] { status = bench(*options); });
}

}  // namespace echoway::tools
