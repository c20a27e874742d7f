#include "rooms.hpp"

#include <cmath>
#include <stdexcept>

#include "echoway/geometry/box.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "plans.hpp"

namespace echoway::report {
namespace {

Vec2 random_place(const Room& room, Random& random) {
  constexpr double kClear = 0.5;  // Metres to whatever is on the plan.
  const auto [low, high] = box_about(room.boundary);
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const Vec2 p{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    const auto clear = [&](const Segment& s) { return distance(s, p) >= kClear; };
    if (contains(room.boundary, p) && std::all_of(room.walls.begin(), room.walls.end(), clear) &&
        std::all_of(room.reflectors.begin(), room.reflectors.end(), clear)) {
      return p;
    }
  }
  throw std::runtime_error("room " + room.id + " has no place to stand");
}

}  // namespace

RoomMatcher::RoomMatcher(const Building& plan, RoomIndex room, const BeltConfig& belt,
                         const ThesisParameters& parameters)
    : belt_(belt),
      parameters_(parameters),
      matcher_(plan.room(room), openings_of(plan, room), belt, DetectionTable(belt, parameters.detection), parameters),
      workspace_(belt, parameters),
      echoes_(parameters) {
  echoes_.reserve(belt.sensors);
}

thesis::Match RoomMatcher::match(const thesis::Scan& scan, const Pose2& start) {
  return matcher_.match(scan, {start.position, parameters_.movement_m, start.heading, parameters_.rotation_rad},
                        workspace_);
}

std::optional<double> RoomMatcher::objective(const thesis::Scan& scan, const Pose2& pose) {
  if (!matcher_.floor().contains(pose.position)) return std::nullopt;
  echoes_.simulate(matcher_.model(), pose.position, Directions(pose.heading, belt_.sensors));
  const thesis::Score score = echoes_.score(scan, 0, 1);
  if (score.matched < parameters_.least_matches) return std::nullopt;
  return score.objective_m;
}

Pose2 approximate(const Room& room, const Pose2& truth, Random& random) {
  constexpr double kOff = feet(4.0);
  constexpr double kTurned = degrees(15.0);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const double away = kOff * std::sqrt(random.uniform());
    const Vec2 position = truth.position + away * unit_from_angle(random.uniform(0.0, kTwoPi));
    const double heading = wrap_angle(truth.heading + random.uniform(-kTurned, kTurned));
    if (contains(room.boundary, position)) return {position, heading};
  }
  return truth;
}

std::vector<Pose2> random_places(const Room& room, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Pose2> places;
  for (int i = 0; i < count; ++i) {
    const Vec2 at = random_place(room, random);
    places.push_back({at, random.uniform(-kPi, kPi)});
  }
  return places;
}

std::vector<thesis::Scan> scans_at(const Building& world, std::string_view room, const std::vector<Pose2>& places,
                                   const sim::World& contents, std::uint64_t seed) {
  const sim::Ring ring{};
  const ThesisParameters parameters{};
  std::vector<TruthRow> stands;
  for (const Pose2& place : places) {
    for (int pass = 0; pass < parameters.passes; ++pass) {
      stands.push_back(
          {static_cast<double>(stands.size()) * ring.belt.sensors * ring.belt.slot_s, std::string(room), place});
    }
  }
  const auto log = sim::scan_at(world, contents, ring, stands, seed);
  if (!log) throw std::runtime_error(log.error().to_string());
  std::vector<thesis::Scan> scans;
  thesis::ScanAssembler assembler(ring.belt, parameters);
  for (const Firing& firing : log->firings) {
    if (assembler.add(firing)) scans.push_back(assembler.scan());
  }
  return scans;
}

sim::Walk walk_of_places(const Building& world, std::string_view room, int places, const sim::World& contents,
                         std::uint64_t seed) {
  Random random(seed);
  const Room& where = world.room(world.find_room(room));
  for (int attempt = 0; attempt < 100; ++attempt) {
    sim::Walk walk;
    walk.seed = random.next();
    walk.world = contents;
    walk.start = {std::string(room), random_place(where, random)};
    walk.start_heading = random.uniform(-kPi, kPi);
    walk.add(sim::Pause{pause_for(walk.belt)});
    for (int i = 1; i < places; ++i) {
      walk.add(sim::GoTo{{std::string(room), random_place(where, random)}});
      walk.add(sim::Face{random.uniform(-kPi, kPi)});
      walk.add(sim::Pause{pause_for(walk.belt)});
    }
    if (sim::simulate(world, walk)) return walk;  // Some places cannot be walked to; draw others.
  }
  throw std::runtime_error("room " + std::string(room) + " cannot be walked about in");
}

CircularWalk circular_walk(int sensors, sim::Profile profile, std::uint64_t seed) {
  constexpr double kStep = feet(1.0);
  constexpr double kTurn = degrees(10.0);
  constexpr double kSharpTurn = degrees(30.0);
  constexpr int kStops = 36;
  CircularWalk circular;
  circular.sharp_turn = kStops / 2;
  circular.walk.seed = seed;
  circular.walk.belt.sensors = sensors;
  circular.walk.world = sim::make_world(profile);
  circular.walk.start = {"sample", {feet(17.0), feet(11.0)}};
  circular.walk.start_heading = degrees(90.0);
  const double pause_s = pause_for(circular.walk.belt);
  circular.walk.add(sim::Pause{pause_s});
  Pose2 pose{circular.walk.start.at, circular.walk.start_heading};
  for (int stop = 1; stop < kStops; ++stop) {
    pose.heading += stop == circular.sharp_turn ? kSharpTurn : kTurn;
    pose.position = pose.position + kStep * unit_from_angle(pose.heading);
    circular.walk.add(sim::GoTo{{"sample", pose.position}});
    circular.walk.add(sim::Face{wrap_angle(pose.heading)});
    circular.walk.add(sim::Pause{pause_s});
  }
  return circular;
}

}  // namespace echoway::report
