#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "echoway/building/loader.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "sim/rooms.hpp"

namespace echoway::sim {
namespace {

std::vector<std::string> rooms_of(const Simulation& run) {
  std::vector<std::string> rooms;
  for (const TruthRow& row : run.truth) {
    if (rooms.empty() || rooms.back() != row.room) rooms.push_back(row.room);
  }
  return rooms;
}

Walk from_hall() {
  Walk walk;
  walk.start = {"hall", {1.0, 1.0}};
  return walk;
}

std::vector<MotionHint> of_kind(const Simulation& run, MotionKind kind) {
  std::vector<MotionHint> hints = run.motion;
  std::erase_if(hints, [kind](const MotionHint& hint) { return hint.kind != kind; });
  return hints;
}

TEST(Simulate, GivesTheSameBytesForTheSameSeed) {
  const Building building = three_rooms();
  RandomWalkOptions options;
  options.duration_s = 20.0;
  const Walk walk = random_walk(building, options, 5);
  const Result<Simulation> one = simulate(building, walk, 9);
  const Result<Simulation> two = simulate(building, walk, 9);
  const Result<Simulation> other = simulate(building, walk, 10);
  ASSERT_TRUE(one.ok() && two.ok() && other.ok());
  ASSERT_EQ(one->scans.firings.size(), two->scans.firings.size());
  ASSERT_EQ(one->motion.size(), two->motion.size());
  for (std::size_t i = 0; i < one->scans.firings.size(); ++i) {
    EXPECT_EQ(one->scans.firings[i].range_m, two->scans.firings[i].range_m);
    EXPECT_EQ(one->truth[i].pose, two->truth[i].pose);
  }
  for (std::size_t i = 0; i < one->motion.size(); ++i) EXPECT_EQ(one->motion[i].value, two->motion[i].value);
  std::size_t differences = 0;
  for (std::size_t i = 0; i < std::min(one->scans.firings.size(), other->scans.firings.size()); ++i) {
    differences += one->scans.firings[i].range_m != other->scans.firings[i].range_m;
  }
  EXPECT_GT(differences, one->scans.firings.size() / 10);
}

TEST(Simulate, FiresOneSensorASlotInTurn) {
  Walk walk = from_hall();
  walk.add(Pause{10.0});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok());
  for (std::size_t i = 0; i < run->scans.firings.size(); ++i) {
    EXPECT_EQ(run->scans.firings[i].sensor, static_cast<int>(i % 15));
    EXPECT_NEAR(run->scans.firings[i].time_s, 0.0624 * static_cast<double>(i), 1e-9);
    EXPECT_EQ(run->truth[i].time_s, run->scans.firings[i].time_s);
  }
}

TEST(Simulate, WalksThroughDoorsIntoEveryRoomNamed) {
  Walk walk = from_hall();
  walk.add(GoTo{{"store", {1.0, 1.0}}});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  EXPECT_THAT(rooms_of(*run), testing::ElementsAre("hall", "office", "store"));
  EXPECT_NEAR(distance(run->truth.back().pose.position, {1.0, 1.0}), 0.0, 0.1);
}

TEST(Simulate, WalksAtTheSpeedAskedFor) {
  Walk walk = from_hall();
  walk.world = ideal_world();
  walk.start.at = {1.0, 2.0};
  walk.speed_mps = 0.8;
  walk.add(GoTo{{"hall", {4.0, 2.0}}});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok());
  EXPECT_NEAR(run->truth.back().time_s, 3.0 / 0.8, 0.7);
}

TEST(Simulate, WalksRoundTheCornersOfARoomWithoutTouchingItsWalls) {
  const Building building = one_room(rooms::with_pier());
  Walk walk;
  walk.start = {"P", {1.0, 0.7}};
  walk.add(GoTo{{"P", {5.0, 0.7}}});
  const Result<Simulation> run = simulate(building, walk);
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  for (const TruthRow& row : run->truth) {
    ASSERT_TRUE(contains(building.rooms[0].boundary, row.pose.position));
    for (const Segment& wall : building.rooms[0].walls) EXPECT_GT(distance(wall, row.pose.position), 0.15);
  }
}

TEST(Simulate, ThePositionDoesNotJumpInADoor) {
  Building building = three_rooms();
  building.rooms[1].frame = {{5.0, 0.0}, 0.0};
  Walk walk = from_hall();
  walk.add(GoTo{{"office", {3.0, 3.0}}});
  const Result<Simulation> run = simulate(building, walk);
  ASSERT_TRUE(run.ok());
  Vec2 before = run->truth.front().pose.position;
  for (const TruthRow& row : run->truth) {
    const Vec2 at = building.room(building.find_room(row.room)).frame.transform(row.pose.position);
    EXPECT_LT(distance(at, before), 0.1);
    before = at;
  }
}

TEST(Simulate, TurnsOnTheSpotByTheAngleAskedFor) {
  Walk walk = from_hall();
  walk.world = ideal_world();
  walk.add(TurnBy{degrees(270.0)});
  walk.add(Face{degrees(10.0)});
  walk.add(Pause{1.0});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok());
  EXPECT_NEAR(to_degrees(run->truth.back().pose.heading), 10.0, 1.5);
  EXPECT_EQ(run->truth.back().pose.position, walk.start.at);
  double turned = 0.0;
  for (const MotionHint& hint : of_kind(*run, MotionKind::yaw_rate)) turned += hint.value / walk.world.gyro_rate_hz;
  EXPECT_NEAR(to_degrees(turned), 370.0, 5.0) << "the long way by TurnBy, on the short way by Face";
}

TEST(Simulate, TheGyroscopeHasItsBias) {
  Walk walk = from_hall();
  walk.world.gyro_bias_rad_s = degrees(0.8);
  walk.add(Pause{200.0});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok());
  double sum = 0.0;
  const std::vector<MotionHint> rates = of_kind(*run, MotionKind::yaw_rate);
  for (const MotionHint& hint : rates) sum += hint.value;
  EXPECT_NEAR(to_degrees(sum / static_cast<double>(rates.size())), 0.8, 0.1);
}

TEST(Simulate, StepsAreAsLongAsTheWearers) {
  Walk walk = from_hall();
  walk.world = ideal_world();
  walk.world.step_length_m = 0.5;
  walk.start.at = {0.5, 2.0};
  walk.add(GoTo{{"hall", {4.5, 2.0}}});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok());
  EXPECT_NEAR(static_cast<double>(of_kind(*run, MotionKind::step).size()), 4.0 / 0.5, 1.0);
}

TEST(Simulate, TheStepDetectorMissesAndInventsSteps) {
  Walk walk = from_hall();
  walk.world = ideal_world();
  walk.start.at = {0.5, 2.0};
  for (int i = 0; i < 20; ++i) walk.add(GoTo{{"hall", {i % 2 == 0 ? 4.5 : 0.5, 2.0}}});
  const auto steps = [&] { return of_kind(*simulate(three_rooms(), walk), MotionKind::step).size(); };
  const auto all = static_cast<double>(steps());
  walk.world.step_missed = 0.3;
  EXPECT_NEAR(static_cast<double>(steps()) / all, 0.7, 0.15);
  walk.world.step_missed = 1.0;
  walk.world.step_invented_per_min = 10.0;
  EXPECT_GT(steps(), 5U);
}

TEST(Simulate, TheAbsoluteHeadingIsOfTheLevelAndDrifts) {
  Building building = three_rooms();
  building.rooms[0].frame.heading = degrees(90.0);
  Walk walk = from_hall();
  walk.world = ideal_world();
  walk.world.heading = true;
  walk.world.heading_drift_rad_s = degrees(0.1);
  walk.add(Pause{100.0});
  const Result<Simulation> run = simulate(building, walk);
  ASSERT_TRUE(run.ok());
  const std::vector<MotionHint> headings = of_kind(*run, MotionKind::heading);
  ASSERT_FALSE(headings.empty());
  EXPECT_NEAR(to_degrees(headings.front().value), 90.0, 3.0);
  EXPECT_NEAR(to_degrees(headings.back().value), 100.0, 3.0);
}

TEST(Simulate, AWearerCarriedBlindfoldIsElsewhereAtOnceAndTheGyroscopeMissedIt) {
  Walk walk = from_hall();
  walk.world = ideal_world();
  walk.add(Pause{5.0});
  walk.add(Teleport{{"store", {2.0, 1.5}}, degrees(180.0)});
  walk.add(Pause{5.0});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok());
  EXPECT_THAT(rooms_of(*run), testing::ElementsAre("hall", "store"));
  EXPECT_EQ(run->truth.back().pose.position, (Vec2{2.0, 1.5}));
  for (const MotionHint& hint : of_kind(*run, MotionKind::yaw_rate)) EXPECT_EQ(hint.value, 0.0);
}

Building with_upper_floor(LevelLinkKind kind) {
  Building building = three_rooms();
  Room upper = box_room("upper", {0.0, 0.0}, 5.0, 5.0);
  upper.level = 1;
  building.rooms.push_back(upper);
  building.links = {{kind, 2, {2.0, 1.5}, 3, {2.0, 2.0}}};
  return building;
}

TEST(Simulate, TakesTheStairsBetweenLevels) {
  Walk walk = from_hall();
  walk.add(GoTo{{"upper", {4.0, 4.0}}});
  const Result<Simulation> run = simulate(with_upper_floor(LevelLinkKind::stairs), walk);
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  EXPECT_THAT(rooms_of(*run), testing::ElementsAre("hall", "office", "store", "upper"));
}

/// The walk's rows at either end of the link, while its room's own walls are not heard.
struct OnTheWayUp {
  double seconds = 0.0;
  double turned = 0.0;  ///< Radians, by the gyroscope.
  int steps = 0;
  int echoes = 0;
  int firings = 0;
};
OnTheWayUp way_up(LevelLinkKind kind) {
  Walk walk = from_hall();
  walk.world = ideal_world();
  walk.start = {"store", {2.0, 1.5}};
  walk.start_heading = 0.0;
  walk.add(GoTo{{"upper", {2.0, 2.0}}});
  const Result<Simulation> run = simulate(with_upper_floor(kind), walk);
  OnTheWayUp way;
  if (!run.ok()) return way;
  way.seconds = run->truth.back().time_s;
  double last = 0.0;
  for (const MotionHint& hint : of_kind(*run, MotionKind::yaw_rate)) {
    way.turned += hint.value * (hint.time_s - last);
    last = hint.time_s;
  }
  way.steps = static_cast<int>(of_kind(*run, MotionKind::step).size());
  for (const Firing& firing : run->scans.firings) way.echoes += firing.has_echo() ? 1 : 0;
  way.firings = static_cast<int>(run->scans.firings.size());
  return way;
}

TEST(Simulate, StairsAreTwoFlightsOfStepsWithATurnBetween) {
  const OnTheWayUp way = way_up(LevelLinkKind::stairs);
  EXPECT_GT(way.seconds, 12.0);  // two flights of five to eight seconds and a landing
  EXPECT_LT(way.seconds, 25.0);
  EXPECT_GE(way.steps, 18);  // a step a tread, and those on the landing
  EXPECT_LE(way.steps, 28);
  EXPECT_NEAR(std::abs(way.turned), kPi, degrees(5.0));
  EXPECT_GT(way.echoes, way.firings / 3);  // of the stairwell
}

TEST(Simulate, AnElevatorCarriesAWearerWhoStandsAndHasTurnedToItsDoor) {
  const OnTheWayUp way = way_up(LevelLinkKind::elevator);
  EXPECT_GT(way.seconds, 12.0);
  EXPECT_LE(way.steps, 5);
  EXPECT_NEAR(std::abs(way.turned), kPi, degrees(5.0));
}

TEST(Simulate, SaysWhatIsWrongWithAWalk) {
  const auto message = [](const std::function<void(Walk&)>& change) {
    Walk walk = from_hall();
    change(walk);
    const Result<Simulation> run = simulate(three_rooms(), walk);
    return run.ok() ? std::string("no error") : run.error().message;
  };
  using testing::HasSubstr;
  EXPECT_THAT(message([](Walk& w) { w.add(GoTo{{"cellar", {1, 1}}}); }), HasSubstr("no room cellar"));
  EXPECT_THAT(message([](Walk& w) { w.add(GoTo{{"office", {9, 9}}}); }), HasSubstr("not inside room office"));
  EXPECT_THAT(message([](Walk& w) { w.start.at = {-1, 1}; }), HasSubstr("not inside room hall"));
  EXPECT_THAT(message([](Walk& w) { w.add(SetDoor{"hall", "store", true}); }), HasSubstr("no door joins"));
  EXPECT_THAT(message([](Walk& w) {
                w.add(SetDoor{"hall", "office", false});
                w.add(GoTo{{"office", {1, 1}}});
              }),
              HasSubstr("no way through open doors"));
}

TEST(Simulate, RefusesABeltThatMakesNoSense) {
  const auto ok = [](const std::function<void(Walk&)>& change) {
    Walk walk = from_hall();
    change(walk);
    return simulate(three_rooms(), walk).ok();
  };
  EXPECT_TRUE(ok([](Walk&) {}));
  EXPECT_FALSE(ok([](Walk& w) { w.belt.sensors = 0; }));
  EXPECT_FALSE(ok([](Walk& w) { w.belt.sensors = kMaxSensors + 1; }));
  EXPECT_FALSE(ok([](Walk& w) { w.belt.slot_s = 0.0; }));
  EXPECT_FALSE(ok([](Walk& w) { w.speed_mps = 0.0; }));
  EXPECT_FALSE(ok([](Walk& w) { w.add(Cover{{15}, 1.0}); }));
  EXPECT_FALSE(ok([](Walk& w) { w.add(Pause{1e6}); }));
  EXPECT_FALSE(ok([](Walk& w) { w.start.at.x = std::nan(""); }));
}

TEST(Simulate, KeepsFurnitureAndShutDoorsOutOfTheWay) {
  const Result<Building> building = load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  ASSERT_TRUE(building.ok());
  RandomWalkOptions options;
  options.duration_s = 30.0;
  options.profile = Profile::hard;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Result<Simulation> run = simulate(*building, random_walk(*building, options, seed));
    EXPECT_TRUE(run.ok()) << run.error().to_string();
  }
}

TEST(RandomWalk, VisitsSeveralRoomsForAboutAsLongAsAsked) {
  RandomWalkOptions options;
  options.duration_s = 200.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Building building = three_rooms();
    const Result<Simulation> run = simulate(building, random_walk(building, options, seed));
    ASSERT_TRUE(run.ok()) << run.error().to_string();
    EXPECT_GE(rooms_of(*run).size(), 3U);
    EXPECT_NEAR(run->truth.back().time_s, 200.0, 70.0);
  }
}

TEST(RandomWalk, BringsTeleportsAndCoveredSensorsWhenAsked) {
  RandomWalkOptions options;
  options.teleport_probability = 0.5;
  options.cover_probability = 0.5;
  const Walk walk = random_walk(three_rooms(), options, 1);
  const auto count = [&](auto tag) {
    return std::count_if(walk.steps.begin(), walk.steps.end(),
                         [](const WalkStep& s) { return std::holds_alternative<decltype(tag)>(s.action); });
  };
  EXPECT_GT(count(Teleport{}), 0);
  EXPECT_GT(count(Cover{}), 0);
  EXPECT_TRUE(simulate(three_rooms(), walk).ok());
}

TEST(RandomWalk, NeverLeadsOntoABench) {
  Building building = one_room(rooms::rectangle(6.0, 6.0));
  building.rooms[0].reflectors = {
      {{1.5, 1.5}, {4.5, 1.5}}, {{4.5, 1.5}, {4.5, 4.5}}, {{4.5, 4.5}, {1.5, 4.5}}, {{1.5, 4.5}, {1.5, 1.5}}};
  const Result<Simulation> run = simulate(building, random_walk(building, {}, 1));
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  for (const TruthRow& row : run->truth) {
    const Vec2 p = row.pose.position;
    EXPECT_FALSE(p.x > 1.5 && p.x < 4.5 && p.y > 1.5 && p.y < 4.5);
  }
}

TEST(RandomWalk, HasNoLegsInABuildingWithoutRooms) {
  EXPECT_TRUE(random_walk(Building{}, {}, 1).steps.empty());
  EXPECT_FALSE(simulate(Building{}, random_walk(Building{}, {}, 1)).ok());
}

}  // namespace
}  // namespace echoway::sim
