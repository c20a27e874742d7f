// Figures 6.5 to 6.7: a match, and the error surface over the room at the true heading.
#include "experiment.hpp"
#include "plans.hpp"
#include "readings.hpp"
#include "surface.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

constexpr double kSpacing = feet(0.25);

sim::Simulation stand(const Building& world, std::string_view room, const Pose2& pose, std::uint64_t seed) {
  sim::Walk walk;
  walk.seed = seed;
  walk.world = world_of_room(room);
  walk.start = {std::string(room), pose.position};
  walk.start_heading = pose.heading;
  walk.add(sim::Pause{pause_for(walk.belt)});
  return walk_through(world, walk);
}

void show_case(std::string_view figure, std::string_view room, const Pose2& truth, std::uint64_t seed, const Building& lab,
               Table& poses, Table& readings, Table& surface) {
  const RoomIndex index = lab.find_room(room);
  const sim::Simulation walk = stand(lab, room, truth, seed);
  const Stop stop = find_stops(lab, walk).front();
  Random random(seed);
  const BeltConfig belt{};
  RoomMatcher matcher(lab, index, belt, {});
  const thesis::Scan scan = scan_at(stop, walk, {});
  const thesis::Match match = matcher.match(scan, approximate(lab.room(index), truth, random));
  poses.add(figure, room, "true", truth.position.x, truth.position.y, to_degrees(truth.heading), 0.0, 0.0);
  poses.add(figure, room, "best", match.pose.position.x, match.pose.position.y, to_degrees(match.pose.heading),
            match.objective_m, match.quality);
  add_readings(figure, scan, matcher.matcher().model(), match.pose, readings);
  for (const bool printed : {true, false}) {
    const ThesisParameters parameters = printed ? ThesisParameters::as_printed() : ThesisParameters{};
    RoomMatcher of_variant(lab, index, belt, parameters);
    for (const auto& point : error_surface(of_variant, scan, truth.heading, lab.room(index), kSpacing).points) {
      surface.add(figure, printed ? "as printed" : "thesis", point.at.x, point.at.y, point.objective_m);
    }
  }
}

// How often there is one minimum only, and how near it lies, over many places.
std::string places_of(const Building& lab, const std::string& room, bool bare, int places) {
  const RoomIndex index = lab.find_room(room);
  const sim::World world = bare ? sim::make_world(sim::Profile::empty) : world_of_room(room);
  const sim::Walk walk = walk_of_places(lab, room, places, world, 660 + static_cast<std::uint64_t>(index));
  const sim::Simulation run = walk_through(lab, walk);
  const std::vector<Stop> stops = find_stops(lab, run);
  Table rows;
  for (const bool printed : {true, false}) {
    const ThesisParameters parameters = printed ? ThesisParameters::as_printed() : ThesisParameters{};
    RoomMatcher matcher(lab, index, walk.belt, parameters);
    for (std::size_t place = 0; place < stops.size(); ++place) {
      const Pose2& truth = stops[place].pose;
      const thesis::Scan scan = scan_at(stops[place], run, parameters);
      const Surface surface = error_surface(matcher, scan, truth.heading, lab.room(index), 2.0 * kSpacing);
      const Surface near = surface.within(truth.position, parameters.movement_m);
      if (near.points.empty()) continue;
      rows.add(bare ? "bare" : "furnished", room, place, printed ? "as printed" : "thesis",
               distance(surface.lowest().at, truth.position), surface.rivals(),
               distance(near.lowest().at, truth.position), near.rivals());
    }
  }
  return rows.text();
}

Table many_places(const Context& context, const Building& lab) {
  const std::vector<std::string> rooms{"1", "4", "5"};
  const int kinds = static_cast<int>(rooms.size());
  const auto parts = run_all(context, 2 * kinds, [&](int i) {
    return places_of(lab, rooms[static_cast<std::size_t>(i % kinds)], i < kinds, context.repeats(40));
  });
  Table table("world,room,place,variant,lowest_error_m,rivals,lowest_error_near_m,rivals_near");
  for (const std::string& rows : parts) table.append(rows);
  return table;
}

}  // namespace

void run_match(const Context& context) {
  const Building lab = load_plan("torgersen-lab");
  Table poses("figure,room,kind,x_m,y_m,heading_deg,objective_m,quality");
  Table readings(kReadingColumns);
  Table surface("figure,variant,x_m,y_m,objective_m");
  show_case("6.5", "1", {{feet(8.0), feet(5.0)}, degrees(75.0)}, 65, lab, poses, readings, surface);
  show_case("6.7", "5", {{feet(12.0), feet(11.0)}, degrees(20.0)}, 67, lab, poses, readings, surface);
  poses.write(context.out / "match-poses.csv");
  readings.write(context.out / "match-readings.csv");
  surface.write(context.out / "match-surface.csv");
  many_places(context, lab).write(context.out / "match-places.csv");
}

}  // namespace echoway::report
