// Tables 6.1 and 6.2, figures 6.9 and 6.10: six rooms, three sets of ten places.
#include "experiment.hpp"
#include "plans.hpp"
#include "rooms.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

constexpr int kPlaces = 10;
const std::vector<std::string> kRooms{"1", "4", "5", "3", "6", "hall"};

// The thesis's method at every place, from an approximate pose.
void match_places(const Building& plan, std::string_view plan_name, std::string_view room, int set,
                  const sim::Simulation& run, const std::vector<Stop>& stops, const Estimator& method, Table& rows) {
  const RoomIndex index = plan.find_room(room);
  RoomMatcher matcher(plan, index, run.scans.belt.apply_to({}), method.parameters);
  Random random(static_cast<std::uint64_t>(set) * 977 + 5);
  for (std::size_t place = 0; place < stops.size(); ++place) {
    const Pose2& truth = stops[place].pose;
    const Pose2 start = approximate(plan.room(index), truth, random);
    const thesis::Match match = matcher.match(scan_at(stops[place], run, method.parameters), start);
    const Pose2 pose = match.found ? match.pose : start;
    rows.add(room, plan_name, set, place, method.name, distance(pose.position, truth.position),
             to_degrees(wrap_angle(pose.heading - truth.heading)), match.found ? match.quality : 1.0);
  }
}

// The tracker when it has walked there from the first place.
void track_places(const Trial& trial, std::string_view plan_name, std::string_view room, int set,
                  const std::vector<Stop>& stops, const Estimator& method, Table& rows) {
  const Track track = follow(trial, method);
  const auto passes = static_cast<std::size_t>(2 * trial.walk.scans.belt.apply_to({}).sensors);
  for (std::size_t place = 0; place < stops.size(); ++place) {
    const std::size_t last = stops[place].first + passes - 1;
    if (last >= track.fixes.size()) continue;
    const Fix& fix = track.fixes[last];
    rows.add(room, plan_name, set, place, method.name, fix.error_m, to_degrees(fix.turn_rad), 0.0);
  }
}

std::string one_set(const Building& lab, const Building& bare, const std::string& room, int set, bool tracked) {
  Table rows;
  const std::uint64_t seed = 6100 + 10 * static_cast<std::uint64_t>(set) + room.front();
  const sim::Walk walk = walk_of_places(lab, room, kPlaces, world_of_room(room), seed);
  const sim::Simulation run = walk_through(lab, walk);
  const std::vector<Stop> stops = find_stops(lab, run);
  const bool benches = !lab.room(lab.find_room(room)).reflectors.empty();
  for (const bool with : {false, true}) {
    if (with && !benches) continue;
    const Building& plan = with ? lab : bare;
    const std::string_view name = with ? "benches on the plan" : "benches not on the plan";
    for (const Estimator& method : {thesis_method(), thesis_as_printed()}) {
      match_places(plan, name, room, set, run, stops, method, rows);
    }
    if (!tracked) continue;
    for (const Estimator& method : {tracker(), tracker_without_hints()}) {
      track_places({lab, plan, run, kReferenceCelsius, walk.seed}, name, room, set, stops, method, rows);
    }
  }
  return rows.text();
}

}  // namespace

void run_single_room(const Context& context) {
  const Building lab = load_plan("torgersen-lab");
  const Building bare = without_reflectors(lab);
  const int sets = context.quick ? 3 : 9;  // The thesis has three; more make steadier figures.
  const int tracked = context.repeats(4);  // A tracker that is told a plan without the benches searches all the while.
  const int rooms = static_cast<int>(kRooms.size());
  const auto parts = run_all(context, rooms * sets, [&](int i) {
    return one_set(lab, bare, kRooms[static_cast<std::size_t>(i % rooms)], 1 + i / rooms, i / rooms < tracked);
  });
  Table table("room,plan,set,place,method,error_m,turn_deg,quality");
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "single-room.csv");
}

}  // namespace echoway::report
