// Figures 6.11 and 6.12: how many sensors, on the circular walk.
#include "experiment.hpp"
#include "plans.hpp"
#include "rooms.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

std::string one_walk(const Building& room, bool bare, int sensors, int number) {
  Table rows;
  const sim::Profile profile = bare ? sim::Profile::empty : sim::Profile::furnished;
  const CircularWalk circular = circular_walk(sensors, profile, 600 + static_cast<std::uint64_t>(number));
  const sim::Simulation run = walk_through(room, circular.walk);
  const std::vector<Stop> stops = find_stops(room, run);
  const Trial trial{room, room, run, kReferenceCelsius, circular.walk.seed};
  const auto add = [&](const Estimator& method, const Fix& fix, std::size_t stop) {
    rows.add(bare ? "bare" : "furnished", sensors, number, method.name, stop, fix.error_m, to_degrees(fix.turn_rad));
  };
  const std::vector<Firing> standing = firings_at(stops, run);
  for (const Estimator& method : {thesis_method(), thesis_as_printed()}) {
    const Track track = follow(trial, method, standing);
    for (std::size_t i = 0; i < track.fixes.size(); ++i) add(method, track.fixes[i], i);
  }
  for (const Estimator& method : {tracker(), tracker_without_hints()}) {
    const Track track = follow(trial, method);
    for (std::size_t i = 0; i < stops.size(); ++i) {
      add(method, track.fixes[stops[i].first + static_cast<std::size_t>(2 * sensors) - 1], i);
    }
  }
  return rows.text();
}

}  // namespace

void run_sensor_count(const Context& context) {
  const Building room = load_plan("sample-room");
  const std::vector<int> counts{8, 12, 15, 24};
  const int walks = context.repeats(12);
  const int kinds = static_cast<int>(counts.size());
  const auto parts = run_all(context, 2 * kinds * walks, [&](int i) {
    return one_walk(room, i % 2 == 0, counts[static_cast<std::size_t>(i / 2 % kinds)], i / 2 / kinds);
  });
  Table table("world,sensors,walk,method,stop,error_m,turn_deg");
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "sensor-count.csv");
}

}  // namespace echoway::report
