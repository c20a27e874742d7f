// Figures 6.17, 6.19, 6.21 and 6.22 to 6.24: walks from room to room.
#include "experiment.hpp"
#include "plans.hpp"
#include "readings.hpp"
#include "rooms.hpp"
#include "table.hpp"
#include "thesis/exits.hpp"

namespace echoway::report {
namespace {

constexpr double kStep = feet(1.0);  // Between the thesis's checkpoints.

struct Case {
  std::string_view figure;
  std::string_view plan;
  std::string_view walk;
  bool benches_on_plan;
};
constexpr Case kCases[] = {
    {"6.17", "torgersen-lab", "thesis", true},
    {"6.19", "similar-rooms", "two-rooms", true},
    {"6.21", "similar-rooms", "three-rooms", true},
    {"6.22 without benches", "torgersen-lab", "benches", false},
    {"6.22 with benches", "torgersen-lab", "benches", true},
};

std::string_view id_of(const Building& plan, RoomIndex room) {
  return room == kNoRoom ? std::string_view("-") : std::string_view(plan.room(room).id);
}

std::uint64_t walk_seed(const Case& c, int number) {
  return read_plan_walk(c.plan, c.walk).seed + 1000 * static_cast<std::uint64_t>(number);
}

sim::Walk walk_of(const Case& c, bool bare, const Building& world, int number) {
  sim::Walk walk = read_plan_walk(c.plan, c.walk);
  walk.seed = walk_seed(c, number);
  walk.world = sim::make_world(bare ? sim::Profile::empty : sim::Profile::furnished);
  return with_stops(world, walk, kStep);
}

struct Walked {
  Building world;
  Building plan;
  sim::Simulation run;
};

Walked walk_once(const Case& c, bool bare, int number) {
  Building world = load_plan(c.plan);
  Building plan = c.benches_on_plan ? world : without_reflectors(world);
  sim::Simulation run = walk_through(world, walk_of(c, bare, world, number));
  return {std::move(world), std::move(plan), std::move(run)};
}

// The thesis's method is fed the standing scans, the tracker everything.
std::string follow_once(const Case& c, bool bare, int number, const Walked& walked, const Estimator& method) {
  const std::vector<Stop> stops = find_stops(walked.world, walked.run);
  const Trial trial{walked.world, walked.plan, walked.run, kReferenceCelsius, walk_seed(c, number)};
  const Track track = method.thesis ? follow(trial, method, firings_at(stops, walked.run)) : follow(trial, method);
  const auto passes = static_cast<std::size_t>(2 * walked.run.scans.belt.apply_to({}).sensors);
  const std::size_t count = method.thesis ? track.fixes.size() : stops.size();
  Table rows;
  for (std::size_t stop = 0; stop < count; ++stop) {
    const Fix& fix = track.fixes[method.thesis ? stop : stops[stop].first + passes - 1];
    const Vec2 on_level = walked.world.room(stops[stop].room).frame.transform(stops[stop].pose.position);
    rows.add(c.figure, bare ? "bare" : "furnished", number, method.name, stop, on_level.x, on_level.y,
             id_of(walked.world, stops[stop].room), id_of(walked.plan, fix.room), fix.error_m,
             to_degrees(fix.turn_rad));
  }
  return rows.text();
}

// Told the true pose: does the right room match better than the one next door?
std::string rooms_told_apart(const Case& c, bool bare, const Walked& walked) {
  Table rows;
  const Building& plan = walked.plan;
  const std::vector<std::vector<thesis::Exit>> exits = thesis::exits_of(plan);
  const BeltConfig belt = walked.run.scans.belt.apply_to({});
  const ThesisParameters own;
  ThesisParameters next_door;  // A candidate's bounds are wider (section 5.2).
  next_door.movement_m *= next_door.candidate_growth;
  next_door.rotation_rad *= next_door.candidate_growth;
  for (const Stop& stop : find_stops(walked.world, walked.run)) {
    const thesis::Scan scan = scan_at(stop, walked.run, own);
    const thesis::Match here = RoomMatcher(plan, stop.room, belt, own).match(scan, stop.pose);
    for (const thesis::Exit& exit : exits[static_cast<std::size_t>(stop.room)]) {
      const double away = distance(exit.at, stop.pose.position);
      if (away > own.exit_reach_m + own.movement_m) continue;
      const thesis::Match there = RoomMatcher(plan, exit.to, belt, next_door).match(scan, exit.into.compose(stop.pose));
      rows.add(c.figure, bare ? "bare" : "furnished", id_of(plan, stop.room), id_of(plan, exit.to), away,
               here.found ? here.objective_m : 1e3, here.found ? here.quality : 1e3,
               there.found ? there.objective_m : 1e3, there.found ? there.quality : 1e3);
    }
  }
  return rows.text();
}

// Figures 6.23 and 6.24: one place between the benches of room 3, matched with room 3 and with room 2.
void show_room_3(const Context& context) {
  const Building world = load_plan("torgersen-lab");
  const Building plan = without_reflectors(world);
  const sim::Simulation run = walk_through(world, walk_of(kCases[3], true, world, 0));
  const RoomIndex three = world.find_room("3");
  const RoomIndex two = world.find_room("2");
  Table poses("figure,room,kind,x_m,y_m,heading_deg,quality");
  Table readings(kReadingColumns);
  for (const Stop& stop : find_stops(world, run)) {
    if (stop.room != three || stop.pose.position.x < feet(2.0)) continue;
    const thesis::Scan scan = scan_at(stop, run, {});
    const Pose2 in_two = world.room(two).frame.relative(world.room(three).frame.compose(stop.pose));
    for (const auto& [figure, room, start] : {std::tuple{"6.23", three, stop.pose}, std::tuple{"6.24", two, in_two}}) {
      ThesisParameters doubled;  // As for a candidate room (section 5.2).
      doubled.movement_m *= doubled.candidate_growth;
      doubled.rotation_rad *= doubled.candidate_growth;
      RoomMatcher matcher(plan, room, run.scans.belt.apply_to({}), doubled);
      const thesis::Match match = matcher.match(scan, start);
      if (!match.found) continue;
      const Pose2& p = match.pose;
      poses.add(figure, id_of(plan, room), "true", start.position.x, start.position.y, to_degrees(start.heading), 0.0);
      poses.add(figure, id_of(plan, room), "best", p.position.x, p.position.y, to_degrees(p.heading), match.quality);
      add_readings(figure, scan, matcher.matcher().model(), p, readings);
    }
    break;
  }
  poses.write(context.out / "room3-poses.csv");
  readings.write(context.out / "room3-readings.csv");
}

}  // namespace

void run_walks(const Context& context) {
  const int walks = context.repeats(4);
  const int kinds = 2 * static_cast<int>(std::size(kCases));  // Each case bare and furnished.
  const auto case_of = [](int kind) -> const Case& { return kCases[kind / 2]; };
  const auto walked = run_all(context, kinds * walks, [&](int i) {
    return walk_once(case_of(i % kinds), i % 2 == 0, i / kinds);
  });
  const std::vector<Estimator> methods{tracker_without_hints(), tracker(), thesis_method(), thesis_by_objective()};
  const int many = static_cast<int>(methods.size());
  const auto parts = run_all(context, kinds * walks * many, [&](int i) {
    const int walk = i / many;
    return follow_once(case_of(walk % kinds), walk % 2 == 0, walk / kinds, walked[static_cast<std::size_t>(walk)],
                       methods[static_cast<std::size_t>(i % many)]);
  });
  Table table("figure,world,walk,method,stop,x_m,y_m,true_room,room,error_m,turn_deg");
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "walks.csv");
  const auto apart = run_all(context, kinds, [&](int i) {
    return rooms_told_apart(case_of(i), i % 2 == 0, walked[static_cast<std::size_t>(i)]);
  });
  Table told("figure,world,room,next_door,door_m,own_objective_m,own_quality,other_objective_m,other_quality");
  for (const std::string& rows : apart) told.append(rows);
  told.write(context.out / "rooms-apart.csv");
  show_room_3(context);
}

}  // namespace echoway::report
