// Measures the tracker on simulated walks through a building, or through a random office for each. Adds a row a walk to a
// table; scripts/tracker_figures.sh says which walks docs/tracker.md shows.
#include <CLI/CLI.hpp>

#include <atomic>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "buildings.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "walk_score.hpp"

namespace echoway::eval {
namespace {

struct Options {
  std::string building;           // Empty: a random office for every walk.
  std::string csv;
  std::string profile = "furnished";
  int walks = 16;
  int first = 1;
  int rooms = 4;
  unsigned threads = std::thread::hardware_concurrency();
  double pace_mps = 0.5;
  double cover = 0.0;
  double teleport = 0.0;
  double seconds = 80.0;
  bool no_hints = false;
  bool unknown = false;
  int particles = 0;
};

template <class T>
T expect(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().to_string());
  return std::move(*result);
}

WalkScore walk_and_score(const Options& o, int number) {
  const auto seed = static_cast<std::uint64_t>(number);
  const Building building = o.building.empty() ? random_office(o.rooms, seed) : expect(load_building(o.building));
  const auto profile = sim::profile_of(o.profile);
  if (!profile) throw std::runtime_error("--profile " + o.profile + ": no such profile");
  sim::RandomWalkOptions w;
  w.speed_mps = o.pace_mps;
  w.teleport_probability = o.teleport;
  w.cover_probability = o.cover;
  w.duration_s = o.seconds;
  w.profile = *profile;
  const sim::Simulation walk = expect(sim::simulate(building, sim::random_walk(building, w, seed * 101 + 7)));
  return score_walk(building, walk, {!o.unknown, !o.no_hints, o.particles, seed});
}

// Walks do not know of one another: which thread does which changes no score.
std::vector<WalkScore> all_walks(const Options& o) {
  std::vector<WalkScore> scores(static_cast<std::size_t>(o.walks));
  std::atomic<int> next{0};
  std::atomic<bool> failed{false};
  const auto work = [&] {
    for (int k = next++; k < o.walks && !failed; k = next++) {
      try {
        scores[static_cast<std::size_t>(k)] = walk_and_score(o, o.first + k);
      } catch (const std::exception& problem) {
        fmt::print(stderr, "walk {}: {}\n", o.first + k, problem.what());
        failed = true;
      }
    }
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < o.threads; ++i) others.emplace_back(work);
  work();
  others.clear();
  return failed ? std::vector<WalkScore>{} : scores;
}

void write(const Options& o, const std::vector<WalkScore>& scores, std::FILE* out) {
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const WalkScore& s = scores[k];
    fmt::print(out, "{},{},{},{},{},{:.4f},{:.3f},{:.5f},{:.5f},{:.4f},{:.2f},{:.1f},{:.1f},{:.0f}\n", o.building.empty() ? "offices" : o.building,
               o.unknown ? "unknown" : "known", o.no_hints ? "no" : "yes", o.first + static_cast<int>(k), s.firings, s.error_m,
               s.heading_error_deg, s.right_room, s.within_2_sigma, s.sigma_m, s.found_s, s.median_us, s.mean_us, s.worst_us);
  }
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

int run(const Options& o) {
  const std::unique_ptr<std::FILE, Close> table(o.csv.empty() ? nullptr : std::fopen(o.csv.c_str(), "a"));
  if (!o.csv.empty() && !table) {
    fmt::print(stderr, "{}: cannot be written\n", o.csv);
    return 1;
  }
  const std::vector<WalkScore> scores = all_walks(o);
  write(o, scores, table ? table.get() : stdout);
  return scores.empty() ? 1 : 0;
}

}  // namespace
}  // namespace echoway::eval

int main(int argc, char** argv) {
  echoway::eval::Options o;
  CLI::App app("The tracker on many simulated walks; a row a walk:\n"
               "building,start,hints,walk,firings,error_m,heading_error_deg,right_room,within_2_sigma,sigma_m,found_s,median_us,mean_us,worst_us");
  app.add_option("--building", o.building, "A building's folder; a random office for each walk without")->check(CLI::ExistingDirectory);
  app.add_option("--rooms", o.rooms, "Rooms on either side of a random office")->check(CLI::Range(1, 200))->capture_default_str();
  app.add_option("--walks", o.walks, "How many")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--first", o.first, "Number of the first; it says all about a walk")->capture_default_str();
  app.add_option("--seconds", o.seconds, "Of each, about")->check(CLI::Range(1.0, 3600.0))->capture_default_str();
  app.add_option("--speed", o.pace_mps, "m/s")->check(CLI::Range(0.1, 3.0))->capture_default_str();
  app.add_option("--profile", o.profile, "Of the simulated world: empty, furnished, hard")->capture_default_str();
  app.add_option("--teleport", o.teleport, "Probability of being carried off at each goal")->check(CLI::Range(0.0, 1.0));
  app.add_option("--cover", o.cover, "Probability that the sensors are covered at each goal")->check(CLI::Range(0.0, 1.0));
  app.add_flag("--no-hints", o.no_hints, "Without the phone's motion sensors");
  app.add_flag("--unknown", o.unknown, "Without being told the start");
  app.add_option("--particles", o.particles, "The tracker's own number without")->check(CLI::Range(1, 2400));
  app.add_option("--threads", o.threads, "Walks at a time")->check(CLI::Range(1u, 256u))->capture_default_str();
  app.add_option("--csv", o.csv, "Add the rows to this file");
  CLI11_PARSE(app, argc, argv);
  return echoway::eval::run(o);
}
