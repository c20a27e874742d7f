// What each part of the tracker buys: its own parts, what it is told, and what the plan says.
#include <functional>

#include "experiment.hpp"
#include "plans.hpp"
#include "roaming.hpp"
#include "stops.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

constexpr double kSeconds = 60.0;
constexpr double kSpeed = 0.5;
constexpr double kWarm = 32.0;  // Degrees, for the thermometer's sake.

struct Label {
  std::string group;
  std::string level;
};

/// One way of following a walk, and every comparison that it is part of.
struct Variant {
  std::vector<Label> labels;
  Estimator estimator;
  std::function<Building(const Building&)> plan{};
  bool warm = false;
};

Estimator with(const std::function<void(Estimator&)>& change, Estimator estimator = tracker()) {
  change(estimator);
  return estimator;
}

const char* budget_of(const Estimator& estimator) {
  return estimator.turns ? "particles with hints" : "particles without hints";
}

Variant budget(int particles, Estimator estimator) {
  estimator.bayes.particles = estimator.bayes.particles_without_gyroscope = particles;
  return {{{budget_of(estimator), std::to_string(particles)}}, std::move(estimator)};
}

struct Part {
  const char* name;
  bool TrackerParts::* flag;
};

constexpr Part kParts[] = {
    {"evidence from missing echoes", &TrackerParts::silence},
    {"askew answers of near walls", &TrackerParts::rough_walls},
    {"corners heard by way of walls", &TrackerParts::mirrored_corners},
    {"furniture before walls", &TrackerParts::furniture},
    {"repeated echoes as one surprise", &TrackerParts::repeats},
    {"speed by what stands in no plan", &TrackerParts::range_rate},
    {"memory of unmapped furniture", &TrackerParts::memory},
    {"a resting sensor counted once", &TrackerParts::novelty},
    {"estimated speed of sound", &TrackerParts::sound_speed},
    {"search when echoes fit badly", &TrackerParts::recovery},
    {"places apart kept", &TrackerParts::modes},
    {"proof of what was found", &TrackerParts::probation},
    {"a second belief without gyroscope", &TrackerParts::understudy},
};

/// The tracker without each of its parts.
void withhold_parts(const std::string& group, const Estimator& whole, std::vector<Variant>& all) {
  for (const Part& part : kParts) {
    all.push_back({{{group, part.name}}, with([&](Estimator& e) { e.bayes.parts.*part.flag = false; }, whole)});
  }
}

constexpr const char* kHints = "motion hints";
constexpr const char* kStart = "start";
constexpr const char* kPlan = "plan";
constexpr const char* kWarmAir = "air at 32 degrees";
constexpr const char* kMethod = "method";
constexpr const char* kAllHints = "parts with steps and gyroscope";
constexpr const char* kEchoesAlone = "parts with echoes alone";
constexpr const char* kUnknownStart = "parts from an unknown start";

/// With nothing withheld.
std::vector<Variant> whole_ones(const Estimator& lost) {
  const BayesOptions usual{};
  return {
      {{{kHints, "steps and gyroscope"},
        {kStart, "known pose"},
        {kPlan, "whole"},
        {kMethod, "tracker"},
        {kAllHints, "whole"},
        {budget_of(tracker()), std::to_string(usual.particles)}},
       tracker()},
      {{{kHints, "none"},
        {kPlan, "whole (no hints)"},
        {kEchoesAlone, "whole"},
        {budget_of(tracker_without_hints()), std::to_string(usual.particles_without_gyroscope)}},
       tracker_without_hints()},
      {{{kStart, "nothing known"}, {kUnknownStart, "whole"}}, lost},
  };
}

std::vector<Variant> variants() {
  const auto no_gyro = [](Estimator& e) { e.turns = false; };
  const auto no_steps = [](Estimator& e) { e.steps = false; };
  const auto told_room = [](Estimator& e) { e.told = Estimator::Told::room; };
  const auto thermometer = [](Estimator& e) { e.thermometer = true; };
  const Estimator lost = with([](Estimator& e) { e.told = Estimator::Told::nothing; });
  std::vector<Variant> all = whole_ones(lost);
  const std::vector<Variant> withheld{
      {{{kHints, "gyroscope only"}}, with(no_steps)},
      {{{kHints, "steps only"}}, with(no_gyro)},
      {{{kStart, "known room"}}, with(told_room)},
      {{{kPlan, "no corners and edges"}}, tracker(), without_corners_and_edges},
      {{{kPlan, "no all-reflective lines"}}, tracker(), without_reflectors},
      {{{kPlan, "no corners and edges (no hints)"}}, tracker_without_hints(), without_corners_and_edges},
      {{{kPlan, "no all-reflective lines (no hints)"}}, tracker_without_hints(), without_reflectors},
      {{{kWarmAir, "thermometer"}}, with(thermometer), {}, true},
      {{{kWarmAir, "none: the scale is estimated"}}, tracker(), {}, true},
      {{{kWarmAir, "none: the scale is taken as known"}},
       with([](Estimator& e) { e.bayes.parts.sound_speed = false; }),
       {},
       true},
      {{{kWarmAir, "thesis with thermometer"}}, with(thermometer, thesis_method()), {}, true},
      {{{kWarmAir, "thesis without"}}, thesis_method(), {}, true},
      {{{kMethod, "thesis"}}, thesis_method()},
      {{{kMethod, "thesis as printed"}}, thesis_as_printed()},
  };
  all.insert(all.end(), withheld.begin(), withheld.end());
  withhold_parts(kAllHints, tracker(), all);
  withhold_parts(kEchoesAlone, tracker_without_hints(), all);
  withhold_parts(kUnknownStart, lost, all);
  for (const int particles : {30, 75, 300, 600}) all.push_back(budget(particles, tracker()));
  for (const int particles : {200, 400, 1600}) all.push_back(budget(particles, tracker_without_hints()));
  return all;
}

struct Walked {
  Roam roamed;
  sim::Simulation run;
};

Walked walk_once(int number, bool warm) {
  Roam roamed = roam(number, kSeconds, kSpeed);
  if (warm) roamed.walk.world.temperature_c = kWarm;
  sim::Simulation run = walk_through(roamed.world, roamed.walk);
  return {std::move(roamed), std::move(run)};
}

std::string follow_once(const Walked& walked, const Variant& variant, int number) {
  const Building& world = walked.roamed.world;
  const Building plan = variant.plan ? variant.plan(world) : world;
  const sim::Walk& walk = walked.roamed.walk;
  const Track track = follow({world, plan, walked.run, walk.world.temperature_c, walk.seed}, variant.estimator);
  const Summary s = summarise(track);
  Table rows;
  for (const Label& label : variant.labels) {
    rows.add(label.group, label.level, number, variant.estimator.name, s.mean_m, s.median_m, s.p90_m,
             to_degrees(s.turn_rad), s.right_room, s.within_2_sigma, track.cpu_us());
  }
  return rows.text();
}

}  // namespace

void run_ablations(const Context& context) {
  const std::vector<Variant> all = variants();
  const int walks = context.repeats(16);
  const auto walked = run_all(context, 2 * walks, [](int i) { return walk_once(i / 2, i % 2 == 1); });
  const int kinds = static_cast<int>(all.size());
  const auto parts = run_all(context, walks * kinds, [&](int i) {
    const Variant& variant = all[static_cast<std::size_t>(i % kinds)];
    const int number = i / kinds;
    return follow_once(walked[static_cast<std::size_t>(2 * number + (variant.warm ? 1 : 0))], variant, number);
  });
  Table table(kRoamColumns);
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "ablations.csv");
}

}  // namespace echoway::report
