// Figures 6.25 and 6.26: fluorescent lights in room 5, on and off.
#include <algorithm>

#include "experiment.hpp"
#include "plans.hpp"
#include "readings.hpp"
#include "rooms.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

const Pose2 kPlace{{feet(17.5), feet(12.0)}, 0.0};  // "1.5 feet away from the right wall and facing it".
constexpr double kSettle = 20.0;                    // Seconds of standing in either light.

sim::Walk stand_and_walk_on(int number) {
  sim::Walk walk;
  walk.seed = 6250 + static_cast<std::uint64_t>(number);
  walk.world = sim::make_world(sim::Profile::furnished);
  walk.world.arms = 0.0;  // They hide a third of what the figures are about.
  walk.start = {"5", kPlace.position};
  walk.start_heading = kPlace.heading;
  walk.add(sim::Pause{kSettle});
  walk.add(sim::SetLights{"5", true});
  walk.add(sim::Pause{kSettle});
  walk.add(sim::GoTo{{"5", {feet(9.0), feet(14.0)}}});
  walk.add(sim::GoTo{{"5", {feet(13.0), feet(5.0)}}});
  walk.add(sim::GoTo{{"5", {feet(16.0), feet(12.0)}}});
  walk.add(sim::Pause{2.0});
  return walk;
}

double median_of(const sim::Simulation& run, int sensor, double from_s, double to_s) {
  std::vector<double> heard;
  int fired = 0;
  for (const Firing& firing : run.scans.firings) {
    if (firing.sensor != sensor || firing.time_s < from_s || firing.time_s >= to_s) continue;
    ++fired;
    if (firing.has_echo()) heard.push_back(firing.range_m);
  }
  return 2 * static_cast<int>(heard.size()) > fired ? quantile(heard, 0.5) : Firing::kNoEcho;
}

std::string one_walk(const Building& lab, int number, Table* scans) {
  Table rows;
  const sim::Walk walk = stand_and_walk_on(number);
  const sim::Simulation run = walk_through(lab, walk);
  for (int sensor = 0; scans != nullptr && sensor < walk.belt.sensors; ++sensor) {
    scans->add(sensor, median_of(run, sensor, 0.0, kSettle), median_of(run, sensor, kSettle, 2.0 * kSettle));
  }
  for (const Estimator& method : {thesis_method(), tracker(), tracker_without_hints()}) {
    for (const Fix& fix : follow({lab, lab, run, kReferenceCelsius, walk.seed}, method).fixes) {
      rows.add(number, method.name, fix.time_s, fix.error_m, fix.right() ? 1 : 0);
    }
  }
  return rows.text();
}

}  // namespace

void run_lights(const Context& context) {
  const Building lab = load_plan("torgersen-lab");
  Table scans("sensor,off_m,on_m");
  const auto parts =
      run_all(context, context.repeats(12), [&](int i) { return one_walk(lab, i, i == 0 ? &scans : nullptr); });
  Table table("walk,method,time_s,error_m,right_room");
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "lights.csv");
  scans.write(context.out / "lights-scans.csv");
}

}  // namespace echoway::report
