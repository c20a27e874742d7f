#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/io/atomic_file.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/sim/walk_file.hpp"
#include "echoway/text/number.hpp"
#include "option_checks.hpp"

namespace echoway::tools {
namespace {

struct Options {
  std::string building;
  std::string walk;
  std::string out;
  std::string profile;
  std::vector<std::string> world;
  std::optional<std::uint64_t> seed;
  std::string stands;
  std::vector<double> bearings;
  double radius_m = BeltConfig{}.radius_m;
  double random_s = 0.0;
  bool draw_world = false;
  bool parameters = false;
};

void print_parameters() {
  const sim::World usual = sim::make_world(sim::Profile::furnished);
  const sim::World empty = sim::make_world(sim::Profile::empty);
  const sim::World hard = sim::make_world(sim::Profile::hard);
  fmt::print("{:<30}{:>10}{:>10}{:>10}  {}\n", "parameter", "furnished", "empty", "hard", "");
  for (const sim::WorldParameter& parameter : sim::world_parameters()) {
    fmt::print("{:<30}{:>10.4g}{:>10.4g}{:>10.4g}  {}\n", parameter.name, parameter.get(usual), parameter.get(empty),
               parameter.get(hard), parameter.help);
  }
}

Status set_parameter(const std::string& assignment, sim::World& world) {
  const auto at = [&](const std::string& message) { return Error{"--world " + assignment + ": " + message}; };
  const std::size_t equals = assignment.find('=');
  const sim::WorldParameter* parameter = sim::find_world_parameter(assignment.substr(0, equals));
  if (equals == std::string::npos) return at("should be name=value");
  if (parameter == nullptr) return at("there is no such parameter; --parameters lists them");
  const std::optional<double> value = text::parse_number(assignment.substr(equals + 1));
  if (!value) return at("the value is no number");
  if (*value < parameter->low || *value > parameter->high) {
    return at(fmt::format("the value must be from {:g} to {:g}", parameter->low, parameter->high));
  }
  parameter->set(world, *value);
  return success();
}

Status set_parameters(const Options& options, sim::World& world) {
  for (const std::string& assignment : options.world) {
    if (Status status = set_parameter(assignment, world); !status.ok()) return status;
  }
  return success();
}

sim::Profile profile_of(const Options& options) {
  return sim::profile_of(options.profile).value_or(sim::Profile::furnished);
}

// A walk file names its building relative to itself.
std::string building_of(const Options& options, const sim::Walk& walk) {
  if (!options.building.empty() || walk.building.empty()) return options.building;
  return (std::filesystem::path(options.walk).parent_path() / walk.building).lexically_normal().string();
}

Result<sim::Walk> get_walk(const Options& options) {
  if (options.random_s > 0.0) {
    if (options.building.empty()) return Error{"--random needs --building"};
    const Result<Building> building = load_building(options.building);
    if (!building.ok()) return building.error();
    sim::RandomWalkOptions wanted;
    wanted.duration_s = options.random_s;
    wanted.profile = profile_of(options);
    return sim::random_walk(*building, wanted, options.seed.value_or(1));
  }
  if (options.walk.empty()) return Error{"say which walk: --walk FILE, or --random SECONDS"};
  return sim::read_walk(options.walk, sim::profile_of(options.profile));
}

// One scan at each pose of a truth file.
Status scan_at(const Options& options) {
  if (options.building.empty()) return Error{"--at needs --building"};
  const Result<Building> building = load_building(options.building);
  if (!building.ok()) return building.error();
  const Result<std::vector<TruthRow>> stands = read_truth_log(options.stands);
  if (!stands.ok()) return stands.error();
  const sim::Profile profile = profile_of(options);
  Random random(options.seed.value_or(1));
  sim::World world = options.draw_world ? sim::random_world(profile, random) : sim::make_world(profile);
  if (Status status = set_parameters(options, world); !status.ok()) return status;
  sim::Ring ring;
  ring.belt.radius_m = options.radius_m;
  for (const double bearing : options.bearings) ring.bearings_rad.push_back(degrees(bearing));
  const Result<ScanLog> log = sim::scan_at(*building, world, ring, *stands, options.seed.value_or(1));
  if (!log.ok()) return Error{log.error().message, log.error().line > 0 ? options.stands : "", log.error().line};
  return write_scan_log(*log, options.out + ".scans.csv");
}

/// A prefix that ends with a folder would write hidden files.
Status check_prefix(const std::string& prefix) {
  if (prefix.empty()) return Error{"say where to write: --out PREFIX"};
  if (std::filesystem::path(prefix).has_filename()) return success();
  return Error{
      fmt::format("--out {}: is a folder; name what the files in it begin with, such as {}walk", prefix, prefix)};
}

Status simulate(const Options& options) {
  if (!options.stands.empty()) return scan_at(options);
  Result<sim::Walk> walk = get_walk(options);
  if (!walk.ok()) return walk.error();
  if (Status status = set_parameters(options, walk->world); !status.ok()) return status;
  const std::string dir = building_of(options, *walk);
  if (dir.empty()) return Error{"say in which building: --building DIR, or a line `building DIR` in the walk"};
  const Result<Building> building = load_building(dir);
  if (!building.ok()) return building.error();
  const std::uint64_t seed = options.random_s > 0.0 ? walk->seed : options.seed.value_or(walk->seed);
  const Result<sim::Simulation> run = sim::simulate(*building, *walk, seed);
  if (!run.ok()) return run.error();
  if (const Status written = write_scan_log(run->scans, options.out + ".scans.csv"); !written) return written;
  if (const Status written = write_motion_log(run->motion, options.out + ".motion.csv"); !written) return written;
  if (const Status written = write_truth_log(run->truth, options.out + ".truth.csv"); !written) return written;
  return options.random_s > 0.0 ? write_file(options.out + ".walk", sim::format_walk(*walk)) : success();
}

}  // namespace

void add_simulate(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("simulate", "Walk a wearer through a building: scans, motion hints and the truth");
  auto options = std::make_shared<Options>();
  command->add_option("--building", options->building, "Building folder (default: the one that the walk names)")
      ->check(not_empty());
  auto* walk = command->add_option("--walk", options->walk, "Walk file (docs/walk-files.md)")->check(not_empty());
  auto* random = command
                     ->add_option("--random", options->random_s,
                                  "Instead of a walk file: a random walk of about so many seconds")
                     ->check(decimal(1.0, 36000.0))
                     ->excludes(walk);
  command
      ->add_option("--profile", options->profile,
                   "How severe the world is (default: what the walk says, else furnished)")
      ->check(CLI::IsMember({"empty", "furnished", "hard"}));
  auto* at = command->add_option("--at", options->stands, "Instead of a walk: one scan at each pose of this truth file")
      ->check(not_empty())
      ->excludes(walk)
      ->excludes(random);
  command->add_flag("--draw-world", options->draw_world, "For --at: draw the world's parameters from the seed")
      ->needs(at);
  command->add_option("--bearings", options->bearings, "For --at: the sensors' bearings, degrees (default: the belt's)")
      ->delimiter(',')
      ->check(decimal(-36000.0, 36000.0))
      ->needs(at);
  command->add_option("--radius", options->radius_m, "For --at: from the axis to the transducers, metres")
      ->check(decimal(0.0, 2.0))
      ->needs(at);
  command->add_option("--world", options->world, "Change a parameter of the world: name=value (repeatable)")
      ->allow_extra_args(false);
  command->add_option("--seed", options->seed, "Seed of all chance, instead of the walk's own")->check(whole(0));
  command->add_option("--out", options->out, "Writes PREFIX.scans.csv, PREFIX.motion.csv and PREFIX.truth.csv");
  command->add_flag("--parameters", options->parameters, "List the world's parameters and leave");
  command->callback([options, &status] {
    if (options->parameters) return print_parameters();
    const Status good = check_prefix(options->out);
    const Status done = good ? simulate(*options) : good;
    if (done.ok()) return;
    status = bad_input(done.error());
  });
}

}  // namespace echoway::tools
