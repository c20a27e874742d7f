// The thesis's findings (chapter 6) in kind, with its method as `--method thesis` has it, in the simulated world. The
// same parts make docs/report, which says where the figures differ and why.
#include <gtest/gtest.h>

#include <cmath>

#include "report/following.hpp"
#include "report/plans.hpp"
#include "report/rooms.hpp"
#include "report/surface.hpp"

namespace echoway::report {
namespace {

TEST(Chapter6, TheErrorSurfaceHasOneMinimum) {
  // Figure 6.6, at twenty places: at most of them, within the five feet that the method looks at, in rooms without
  // furniture. Furniture makes other minima (docs/report).
  const Building lab = load_plan("torgersen-lab");
  int places = 0;
  int alone = 0;
  std::vector<double> off;
  for (const std::string room : {"1", "4"}) {
    const RoomIndex index = lab.find_room(room);
    const sim::Walk walk = walk_of_places(lab, room, 10, sim::make_world(sim::Profile::empty), 66);
    const sim::Simulation run = walk_through(lab, walk);
    RoomMatcher matcher(lab, index, walk.belt, ThesisParameters::as_printed());
    for (const Stop& stop : find_stops(lab, run)) {
      const Surface whole =
          error_surface(matcher, scan_at(stop, run, {}), stop.pose.heading, lab.room(index), feet(0.5));
      const Surface near = whole.within(stop.pose.position, feet(5.0));
      ASSERT_FALSE(near.points.empty());
      ++places;
      alone += near.rivals() == 0 ? 1 : 0;
      off.push_back(distance(near.lowest().at, stop.pose.position));
    }
  }
  EXPECT_EQ(places, 20);
  EXPECT_GE(alone, 15);
  EXPECT_LT(quantile(off, 0.5), feet(0.5));
}

// Mean error over the checkpoints of circular walks, matched from approximate poses.
double error_with_weight(double wall_weight, ThesisParameters parameters) {
  parameters.wall_weight = wall_weight;
  const Building room = load_plan("sample-room");
  double sum = 0.0;
  int stops = 0;
  for (const std::uint64_t seed : {600, 601, 602, 603}) {
    const CircularWalk circular = circular_walk(BeltConfig{}.sensors, sim::Profile::furnished, seed);
    const sim::Simulation run = walk_through(room, circular.walk);
    RoomMatcher matcher(room, 0, circular.walk.belt, parameters);
    Random random(seed);
    for (const Stop& stop : find_stops(room, run)) {
      const Pose2 start = approximate(room.room(0), stop.pose, random);
      const thesis::Match match = matcher.match(scan_at(stop, run, parameters), start);
      sum += distance((match.found ? match.pose : start).position, stop.pose.position);
      ++stops;
    }
  }
  EXPECT_EQ(stops, 4 * 36);
  return sum / stops;
}

TEST(Chapter6, EqualWeightsAreWorseThanTwoToOne) {
  // Figure 6.15, though not six times worse as at the thesis's two chosen places.
  EXPECT_GT(error_with_weight(1.0, ThesisParameters::as_printed()),
            1.03 * error_with_weight(2.0, ThesisParameters::as_printed()));
  EXPECT_GT(error_with_weight(1.0, {}), 1.03 * error_with_weight(2.0, {}));
}

double heading_error_after_the_turn(int sensors) {
  const Building room = load_plan("sample-room");
  double sum = 0.0;
  int count = 0;
  for (const std::uint64_t seed : {600, 601, 602, 603}) {
    const CircularWalk circular = circular_walk(sensors, sim::Profile::empty, seed);
    const sim::Simulation run = walk_through(room, circular.walk);
    const std::vector<Stop> stops = find_stops(room, run);
    const Track track = follow({room, room, run}, thesis_method(), firings_at(stops, run));
    EXPECT_EQ(track.fixes.size(), 36U);
    for (std::size_t i = static_cast<std::size_t>(circular.sharp_turn); i < track.fixes.size(); ++i) {
      sum += std::abs(track.fixes[i].turn_rad);
      ++count;
    }
  }
  return to_degrees(sum / count);
}

TEST(Chapter6, EightSensorsLoseTheTurnAndFifteenHoldIt) {
  // Figure 6.12: "magnitude of the orientation error was bounded within 25 degrees in the 15 sensor case". In furnished
  // rooms fifteen lose it too now and then (docs/report).
  EXPECT_GT(heading_error_after_the_turn(8), 45.0);
  EXPECT_LT(heading_error_after_the_turn(15), 25.0);
}

double error_in_room(const std::string& room, bool benches_on_plan) {
  const Building lab = load_plan("torgersen-lab");
  const Building plan = benches_on_plan ? lab : without_reflectors(lab);
  const RoomIndex index = lab.find_room(room);
  RoomMatcher matcher(plan, index, {}, ThesisParameters::as_printed());
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t set = 1; set <= 8; ++set) {
    const std::vector<Pose2> places = random_places(lab.room(index), 10, set);
    const std::vector<thesis::Scan> scans = scans_at(lab, room, places, world_of_room(room), set);
    EXPECT_EQ(scans.size(), places.size());
    Random random(set);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const Pose2 start = approximate(lab.room(index), places[i], random);
      const thesis::Match match = matcher.match(scans[i], start);
      sum += distance((match.found ? match.pose : start).position, places[i].position);
      ++count;
    }
  }
  return sum / count;
}

TEST(Chapter6, AllReflectiveBenchesHelpRoom6MoreThanRoom3) {
  // Table 6.2: 2.71 to 1.40 ft in room 6, 0.91 to 0.61 ft in room 3.
  const double room_6 = error_in_room("6", false) - error_in_room("6", true);
  const double room_3 = error_in_room("3", false) - error_in_room("3", true);
  EXPECT_GT(room_3, 0.0);
  EXPECT_GT(room_6, room_3);
}

}  // namespace
}  // namespace echoway::report
