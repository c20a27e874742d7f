// How long until a wearer who was carried off blindfold is found again, by building.
#include "echoway/sim/random_walk.hpp"
#include "eval/buildings.hpp"
#include "experiment.hpp"
#include "plans.hpp"
#include "roaming.hpp"
#include "stops.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

constexpr double kBefore = 25.0;  // Seconds of walking before
constexpr double kAfter = 90.0;   // and after.
constexpr double kRight = 1.0;    // Found again: the right room and within so many metres
constexpr double kFor = 3.0;      // for so many seconds.
const std::vector<std::string> kBuildings{"similar-rooms", "torgersen-lab", "office", "westport-house"};

Building building_of(const std::string& name, int number) {
  return name == "office" ? eval::random_office(4, 9500 + static_cast<std::uint64_t>(number)) : load_plan(name);
}

sim::Walk carried_off(const Building& world, int number) {
  const auto seed = static_cast<std::uint64_t>(number);
  sim::RandomWalkOptions options;
  options.random_world = false;
  options.duration_s = kBefore;
  sim::Walk walk = sim::random_walk(world, options, 8100 + seed);
  options.duration_s = kAfter;
  const sim::Walk on = sim::random_walk(world, options, 8500 + seed);
  walk.add(sim::Teleport{on.start, on.start_heading});
  for (const sim::WalkStep& step : on.steps) walk.steps.push_back(step);
  return walk;
}

// When the wearer was carried off: the one moment at which the truth leaps.
double leap_of(const Building& world, const sim::Simulation& run) {
  const auto place = [&](const TruthRow& row) {
    return world.room(world.find_room(row.room)).frame.transform(row.pose.position);
  };
  double longest = 0.0;
  double at = 0.0;
  for (std::size_t i = 1; i < run.truth.size(); ++i) {
    const double leap = distance(place(run.truth[i - 1]), place(run.truth[i]));
    if (leap > longest) {
      longest = leap;
      at = run.truth[i].time_s;
    }
  }
  return at;
}

// Seconds after the leap; negative when never. What comes after that is not followed.
double found_after(const Trial& trial, const Estimator& method, double leap_s) {
  double since = -1.0;
  double found = -1.0;
  static_cast<void>(follow(trial, method, [&](const Fix& fix) {
    const bool right = fix.time_s >= leap_s && fix.right() && fix.error_m < kRight;
    if (!right) since = -1.0;
    if (right && since < 0.0) since = fix.time_s;
    if (right && fix.time_s - since >= kFor) found = since - leap_s;
    return found >= 0.0;
  }));
  return found;
}

std::string one_walk(const std::string& name, int number) {
  Table rows;
  const Building world = building_of(name, number);
  const sim::Walk walk = carried_off(world, number);
  const sim::Simulation run = walk_through(world, walk);
  const double leap_s = leap_of(world, run);
  for (const Estimator& method : {thesis_method(), tracker(), tracker_without_hints()}) {
    const Trial trial{world, world, run, kReferenceCelsius, walk.seed};
    rows.add(name, number, method.name, found_after(trial, method, leap_s), run.truth.back().time_s - leap_s);
  }
  return rows.text();
}

}  // namespace

void run_recovery(const Context& context) {
  const int kinds = static_cast<int>(kBuildings.size());
  const auto parts = run_all(context, kinds * context.repeats(16), [&](int i) {
    return one_walk(kBuildings[static_cast<std::size_t>(i % kinds)], i / kinds);
  });
  Table table("building,walk,method,found_s,watched_s");
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "recovery.csv");
}

}  // namespace echoway::report
