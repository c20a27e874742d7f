// What each part of the tracker buys: its own parts, what it is told, and what the plan says.
#include <functional>

#include "experiment.hpp"
#include "plans.hpp"
#include "roaming.hpp"
#include "stops.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

constexpr double kSeconds = 80.0;
constexpr double kSpeed = 0.5;
constexpr double kWarm = 32.0;  // Degrees, for the thermometer's sake.

struct Variant {
  std::string group;
  std::string level;
  Estimator estimator;
  std::function<Building(const Building&)> plan{};
  bool warm = false;
};

Estimator with(const std::function<void(Estimator&)>& change, Estimator estimator = tracker()) {
  change(estimator);
  return estimator;
}

Variant budget(int particles, Estimator estimator) {
  const std::string group = estimator.turns ? "particles with hints" : "particles without hints";
  estimator.bayes.particles = estimator.bayes.particles_without_gyroscope = particles;
  return {group, std::to_string(particles), std::move(estimator)};
}

struct Part {
  const char* name;
  bool TrackerParts::* flag;
};

constexpr Part kParts[] = {
    {"evidence from missing echoes", &TrackerParts::silence},
    {"askew answers of near walls", &TrackerParts::rough_walls},
    {"corners heard by way of walls", &TrackerParts::mirrored_corners},
    {"repeated echoes as one surprise", &TrackerParts::repeats},
    {"memory of unmapped furniture", &TrackerParts::memory},
    {"a resting sensor counted once", &TrackerParts::novelty},
    {"estimated speed of sound", &TrackerParts::sound_speed},
    {"search when echoes fit badly", &TrackerParts::recovery},
    {"proof of what was found", &TrackerParts::probation},
};

/// The tracker whole, then without each of its parts.
void withhold_parts(const std::string& group, const Estimator& whole, std::vector<Variant>& all) {
  all.push_back({group, "whole", whole});
  for (const Part& part : kParts) {
    all.push_back({group, part.name, with([&](Estimator& e) { e.bayes.parts.*part.flag = false; }, whole)});
  }
}

std::vector<Variant> variants() {
  const auto no_gyro = [](Estimator& e) { e.turns = false; };
  const auto no_steps = [](Estimator& e) { e.steps = false; };
  const auto nothing_known = [](Estimator& e) { e.told = Estimator::Told::nothing; };
  std::vector<Variant> all{
      {"motion hints", "steps and gyroscope", tracker()},
      {"motion hints", "gyroscope only", with(no_steps)},
      {"motion hints", "steps only", with(no_gyro)},
      {"motion hints", "none", tracker_without_hints()},
      {"start", "known pose", tracker()},
      {"start", "known room", with([](Estimator& e) { e.told = Estimator::Told::room; })},
      {"start", "nothing known", with(nothing_known)},
      {"plan", "whole", tracker()},
      {"plan", "no corners and edges", tracker(), without_corners_and_edges},
      {"plan", "no all-reflective lines", tracker(), without_reflectors},
      {"plan", "whole (no hints)", tracker_without_hints()},
      {"plan", "no corners and edges (no hints)", tracker_without_hints(), without_corners_and_edges},
      {"plan", "no all-reflective lines (no hints)", tracker_without_hints(), without_reflectors},
      {"air at 32 degrees", "thermometer", with([](Estimator& e) { e.thermometer = true; }), {}, true},
      {"air at 32 degrees", "none: the scale is estimated", tracker(), {}, true},
      {"air at 32 degrees",
       "none: the scale is taken as known",
       with([](Estimator& e) { e.bayes.parts.sound_speed = false; }),
       {},
       true},
      {"air at 32 degrees",
       "thesis with thermometer",
       with([](Estimator& e) { e.thermometer = true; }, thesis_method()),
       {},
       true},
      {"air at 32 degrees", "thesis without", thesis_method(), {}, true},
      {"method", "tracker", tracker()},
      {"method", "thesis", thesis_method()},
      {"method", "thesis as printed", thesis_as_printed()},
  };
  withhold_parts("parts with steps and gyroscope", tracker(), all);
  withhold_parts("parts with echoes alone", tracker_without_hints(), all);
  withhold_parts("parts from an unknown start", with(nothing_known), all);
  for (const int particles : {30, 75, 150, 300, 600}) all.push_back(budget(particles, tracker()));
  for (const int particles : {100, 200, 400, 800, 1600}) all.push_back(budget(particles, tracker_without_hints()));
  return all;
}

std::string one_walk(const std::vector<Variant>& all, int number) {
  Table rows;
  for (const bool warm : {false, true}) {
    Roam roamed = roam(number, kSeconds, kSpeed);
    if (warm) roamed.walk.world.temperature_c = kWarm;
    const sim::Simulation run = walk_through(roamed.world, roamed.walk);
    for (const Variant& variant : all) {
      if (variant.warm != warm) continue;
      const Building plan = variant.plan ? variant.plan(roamed.world) : roamed.world;
      const Trial trial{roamed.world, plan, run, roamed.walk.world.temperature_c, roamed.walk.seed};
      const Track track = follow(trial, variant.estimator);
      const Summary s = summarise(track);
      rows.add(variant.group, variant.level, number, variant.estimator.name, s.mean_m, s.median_m, s.p90_m,
               to_degrees(s.turn_rad), s.right_room, s.within_2_sigma, track.cpu_us);
    }
  }
  return rows.text();
}

}  // namespace

void run_ablations(const Context& context) {
  const std::vector<Variant> all = variants();
  const auto parts = run_all(context, context.repeats(24), [&](int i) { return one_walk(all, i); });
  Table table(kRoamColumns);
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "ablations.csv");
}

}  // namespace echoway::report
