// Figures 6.5 to 6.7: a match, and the error surface over the room at the true heading.
#include "experiment.hpp"
#include "plans.hpp"
#include "readings.hpp"
#include "surface.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

constexpr double kSpacing = feet(0.25);

struct Case {
  std::string_view figure;
  const Building& plan;
  std::string_view room;
  Pose2 truth;
  sim::World furnished;
};

sim::Simulation stand(const Case& c, const sim::World& world) {
  sim::Walk walk;
  walk.seed = 65;
  walk.world = world;
  walk.start = {std::string(c.room), c.truth.position};
  walk.start_heading = c.truth.heading;
  walk.add(sim::Pause{pause_for(walk.belt)});
  return walk_through(c.plan, walk);
}

void show_case(const Case& c, Table& poses, Table& readings, Table& surface) {
  const RoomIndex index = c.plan.find_room(c.room);
  const BeltConfig belt{};
  RoomMatcher matcher(c.plan, index, belt, ThesisParameters::as_printed());
  for (const bool bare : {true, false}) {
    const sim::Simulation walk = stand(c, bare ? sim::make_world(sim::Profile::empty) : c.furnished);
    const thesis::Scan scan = scan_at(find_stops(c.plan, walk).front(), walk, {});
    for (const auto& point : error_surface(matcher, scan, c.truth.heading, c.plan.room(index), kSpacing).points) {
      surface.add(c.figure, bare ? "bare" : "furnished", point.at.x, point.at.y, point.objective_m);
    }
    if (bare) continue;
    Random random(1);
    const thesis::Match match = matcher.match(scan, approximate(c.plan.room(index), c.truth, random));
    const Pose2& p = match.pose;
    poses.add(c.figure, c.room, "true", c.truth.position.x, c.truth.position.y, to_degrees(c.truth.heading), 0.0, 0.0);
    poses.add(c.figure, c.room, "best", p.position.x, p.position.y, to_degrees(p.heading), match.objective_m,
              match.quality);
    add_readings(c.figure, scan, matcher.matcher().model(), p, readings);
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
  const Building sample = load_plan("sample-room");
  Table poses("figure,room,kind,x_m,y_m,heading_deg,objective_m,quality");
  Table readings(kReadingColumns);
  Table surface("figure,world,x_m,y_m,objective_m");
  show_case({"6.5", lab, "1", {{feet(8.0), feet(5.0)}, degrees(75.0)}, world_of_room("1")}, poses, readings, surface);
  show_case(
      {"6.7", sample, "sample", {{feet(12.0), feet(11.0)}, degrees(20.0)}, sim::make_world(sim::Profile::furnished)},
      poses, readings, surface);
  poses.write(context.out / "match-poses.csv");
  readings.write(context.out / "match-readings.csv");
  surface.write(context.out / "match-surface.csv");
  many_places(context, lab).write(context.out / "match-places.csv");
}

}  // namespace echoway::report
