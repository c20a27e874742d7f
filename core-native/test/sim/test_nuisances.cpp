// What goes wrong in real life, one thing at a time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "echoway/sim/walk_file.hpp"
#include "sim/rooms.hpp"

namespace echoway::sim {
namespace {

using testing::Each;
using testing::Field;

// Stands still in the hall for `seconds`, looking at the far wall 3 m off with sensor 0.
Walk stand(double seconds) {
  Walk walk;
  walk.world = ideal_world();
  walk.start = {"hall", {2.0, 2.0}};
  walk.start_heading = kPi;
  walk.add(Pause{seconds});
  return walk;
}

std::vector<Firing> of_sensor(const Simulation& run, int sensor) {
  std::vector<Firing> firings;
  std::copy_if(run.scans.firings.begin(), run.scans.firings.end(), std::back_inserter(firings),
               [sensor](const Firing& firing) { return firing.sensor == sensor; });
  return firings;
}

Simulation run(const Walk& walk, const Building& building = three_rooms()) {
  Result<Simulation> result = simulate(building, walk, 1);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().to_string());
  return result.ok() ? std::move(*result) : Simulation{};
}

double share(const std::vector<Firing>& firings, const std::function<bool(const Firing&)>& what) {
  return static_cast<double>(std::count_if(firings.begin(), firings.end(), what)) /
         static_cast<double>(std::max<std::size_t>(1, firings.size()));
}

bool silent(const Firing& firing) { return !firing.has_echo(); }

TEST(SimNuisances, WithoutAnyTheWallReadsTheSameEveryTime) {
  EXPECT_THAT(of_sensor(run(stand(20.0)), 0), Each(Field(&Firing::range_m, testing::DoubleNear(1.85, 0.005))));
}

TEST(SimNuisances, ADeadSensorIsSilentUntilMended) {
  Walk walk = stand(5.0);
  walk.add(SensorFault{SensorFault::Kind::dead, {0}, 0.0});
  walk.add(Pause{20.0});
  walk.add(SensorFault{SensorFault::Kind::mended, {0}, 0.0});
  walk.add(Pause{5.0});
  for (const Firing& firing : of_sensor(run(walk), 0)) {
    EXPECT_EQ(firing.has_echo(), firing.time_s < 5.0 || firing.time_s >= 25.0) << firing.time_s;
  }
}

TEST(SimNuisances, AllSensorsCanBeDeadOrStuckAndMendedAtOnce) {
  const auto walk = parse_walk(
      "start office 2 2 0\npause 5\nstuck all 1.25\npause 5\ndead all\npause 5\nmend all\npause 5\n", "faults.walk");
  ASSERT_TRUE(walk.ok()) << walk.error().to_string();
  const std::vector<Firing> firings = run(*walk).scans.firings;
  const auto within = [&](double begin_s, double end_s) {
    std::vector<Firing> part;
    for (const Firing& firing : firings) {
      if (firing.time_s >= begin_s && firing.time_s < end_s) part.push_back(firing);
    }
    return part;
  };
  const auto stuck = [](const Firing& firing) { return std::abs(firing.range_m - 1.25) < 0.01; };
  EXPECT_EQ(share(within(5.0, 10.0), stuck), 1.0);
  EXPECT_EQ(share(within(10.0, 15.0), silent), 1.0);
  EXPECT_LT(share(within(15.0, 20.0), silent), 1.0);
  EXPECT_LT(share(within(15.0, 20.0), stuck), 0.5);
}

TEST(SimNuisances, AStuckSensorSaysTheSameWhereverTheWearerGoes) {
  Walk walk = stand(1.0);
  walk.add(SensorFault{SensorFault::Kind::stuck, {3}, 1.25});
  walk.add(GoTo{{"office", {3.0, 3.0}}});
  const std::vector<Firing> firings = of_sensor(run(walk), 3);
  EXPECT_EQ(share(firings, [](const Firing& f) { return std::abs(f.range_m - 1.25) < 0.01 || f.time_s < 1.0; }), 1.0);
}

TEST(SimNuisances, CoveredSensorsAreSilentForAsLongAsTheyAre) {
  Walk walk = stand(5.0);
  walk.add(Cover{{}, 10.0});
  walk.add(Pause{20.0});
  const Simulation result = run(walk);
  for (const Firing& firing : result.scans.firings) {
    const bool covered = firing.time_s >= 5.0 && firing.time_s < 15.0;
    EXPECT_TRUE(!covered || silent(firing)) << firing.time_s;
  }
  EXPECT_GT(share(result.scans.firings, std::not_fn(silent)), 0.0);
  EXPECT_FALSE(silent(of_sensor(result, 0).back()));
}

TEST(SimNuisances, DropOutsAndGhostsComeAsOftenAsAsked) {
  Walk walk = stand(400.0);
  walk.world.dropout = 0.2;
  const std::vector<Firing> dropped = of_sensor(run(walk), 0);
  EXPECT_NEAR(share(dropped, silent), 0.2, 0.06);
  walk.world.dropout = 0.0;
  walk.world.ghost = 0.2;
  const std::vector<Firing> haunted = of_sensor(run(walk), 0);
  const double nearer = share(haunted, [](const Firing& f) { return f.has_echo() && f.range_m < 1.8; });
  EXPECT_NEAR(nearer, 0.2 * (1.8 - 0.15) / (4.0 - 0.15), 0.05);
}

TEST(SimNuisances, NoiseIsAShareOfTheRange) {
  Walk walk = stand(400.0);
  walk.world.range_noise = 0.01;
  double sum2 = 0.0;
  const std::vector<Firing> firings = of_sensor(run(walk), 0);
  for (const Firing& firing : firings) sum2 += (firing.range_m / 1.85 - 1.0) * (firing.range_m / 1.85 - 1.0);
  EXPECT_NEAR(std::sqrt(sum2 / static_cast<double>(firings.size())), 0.01, 0.002);
}

TEST(SimNuisances, ArmsAnswerAndHideWhatIsBehindThem) {
  Walk walk;
  walk.world = ideal_world();
  walk.start = {"office", {1.0, 1.0}};
  walk.add(GoTo{{"office", {5.0, 6.0}}});
  walk.add(GoTo{{"office", {1.0, 1.0}}});
  const auto near = [](const Firing& f) { return f.has_echo() && f.range_m < 0.4; };
  const double without = share(run(walk).scans.firings, near);
  walk.world.arms = 1.0;
  const Simulation with = run(walk);
  EXPECT_GT(share(with.scans.firings, near), without + 0.05);
  EXPECT_EQ(share(of_sensor(with, 0), near), 0.0) << "arms do not swing before the chest";
}

TEST(SimNuisances, TheChestSwaysWithEveryStrideAndNotAtRest) {
  Walk walk;
  walk.world = ideal_world();
  walk.world.yaw_sway_rad = degrees(5.0);
  walk.start = {"office", {1.0, 1.0}};
  walk.start_heading = kPi / 2.0;
  walk.add(Pause{5.0});
  walk.add(GoTo{{"office", {1.0, 6.0}}});
  double resting = 0.0;
  double walking = 0.0;
  for (const TruthRow& row : run(walk).truth) {
    const double off = std::abs(wrap_angle(row.pose.heading - kPi / 2.0));
    double& most = row.pose.position.y < 1.001 ? resting : walking;
    most = std::max(most, off);
  }
  EXPECT_LT(resting, degrees(0.1));
  EXPECT_NEAR(to_degrees(walking), 5.0, 1.0);
}

// How far the gyroscope's readings swing about the way that is walked, degrees.
double swing_of(double phone_swing) {
  Walk walk;
  walk.world = ideal_world();
  walk.world.phone_swing_rad = phone_swing;
  walk.start = {"office", {1.0, 1.0}};
  walk.start_heading = kPi / 2.0;
  walk.add(GoTo{{"office", {1.0, 6.0}}});
  double turned = 0.0, low = 0.0, high = 0.0, before = 0.0;
  for (const MotionHint& hint : run(walk).motion) {
    if (hint.kind != MotionKind::yaw_rate) continue;
    turned += hint.value * (hint.time_s - before);
    before = hint.time_s;
    low = std::min(low, turned);
    high = std::max(high, turned);
  }
  return to_degrees(high - low) / 2.0;
}

TEST(SimNuisances, APhoneOnAThighTurnsWithEveryStrideThoughTheChestDoesNot) {
  EXPECT_LT(swing_of(0.0), 0.1);
  EXPECT_NEAR(swing_of(degrees(10.0)), 10.0, 1.0);
}

TEST(SimNuisances, TheLeafOfAnOpenDoorStandsInARoom) {
  World leaves = ideal_world();
  leaves.door_leaves = 1.0;
  int nearer = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    // Along the wall with the door, from either side: an open leaf stands across.
    const bool below = look(three_rooms(), leaves, {4.5, 0.6}, 90.0, seed, "hall") < 2.5;
    const bool above = look(three_rooms(), leaves, {4.5, 3.4}, -90.0, seed, "hall") < 2.5;
    nearer += below || above ? 1 : 0;
    EXPECT_GT(look(three_rooms(), ideal_world(), {4.5, 0.6}, 90.0, seed, "hall"), 2.5);
  }
  EXPECT_GT(nearer, 2);
  EXPECT_LT(nearer, 20) << "some open into the office";
}

TEST(SimNuisances, PeopleAnswerNearerThanTheWalls) {
  Walk walk = stand(120.0);
  const auto nearer = [](const Firing& f) { return f.has_echo() && f.range_m < 1.7; };
  EXPECT_EQ(share(of_sensor(run(walk), 0), nearer), 0.0);
  walk.world.people_per_100m2 = 20.0;
  EXPECT_GT(share(of_sensor(run(walk), 0), nearer), 0.02);
}

TEST(SimNuisances, FurnitureStandsBeforeWallsAndNeverInTheWay) {
  World world = ideal_world();
  world.furniture_per_m2 = 0.4;
  const Building building = one_room(rooms::rectangle(8.0, 8.0));
  int changed = 0;
  for (int angle = 0; angle < 360; angle += 10) {
    const double bare = look(building, ideal_world(), {4.0, 4.0}, angle);
    const double furnished = look(building, world, {4.0, 4.0}, angle);
    changed += bare != furnished;
    EXPECT_TRUE(furnished < 0.0 || furnished > 0.35) << "kept clear of where the wearer stands";
  }
  EXPECT_GT(changed, 3);
  EXPECT_NE(look(building, world, {4.0, 4.0}, 0.0, 1), -2.0);
}

TEST(SimNuisances, BadBallastsGiveSteadyNearReadingsThatLeaveWhenTheLightsGoOut) {
  Walk walk = stand(60.0);
  walk.add(SetLights{"hall", true});
  walk.add(Pause{120.0});
  walk.add(SetLights{"hall", false});
  walk.add(Pause{60.0});
  const Simulation dark = run(stand(60.0));
  const Simulation lit = run(walk);
  // The sensors that change when the lights go on say the same near range again and again.
  int disturbed = 0;
  for (int sensor = 0; sensor < walk.belt.sensors; ++sensor) {
    const double before = of_sensor(dark, sensor).front().range_m;
    std::vector<Firing> during = of_sensor(lit, sensor);
    std::erase_if(during, [](const Firing& f) { return f.time_s < 60.0 || f.time_s >= 180.0; });
    const double false_range = during.front().range_m;
    if (false_range < 0.0 || false_range == before) continue;
    ++disturbed;
    EXPECT_TRUE(before < 0.0 || false_range < before);
    EXPECT_GT(share(during, [&](const Firing& f) { return std::abs(f.range_m - false_range) < 0.6; }), 0.5);
    EXPECT_EQ(of_sensor(lit, sensor).back().range_m, before);
  }
  EXPECT_GE(disturbed, 1);
}

TEST(SimNuisances, AShortSlotHearsTheFiringBefore) {
  Walk walk = stand(1.0);
  walk.belt.sensors = 1;
  walk.belt.radius_m = 0.0;
  walk.start_heading = kPi;
  walk.start.at = {3.0, 1.0};
  EXPECT_NEAR(run(walk).scans.firings.back().range_m, 3.0, 0.01);
  walk.belt.slot_s = 0.012;  // Sound goes 4.1 m: the echo of a wall 3 m off comes 1.9 m into the next slot.
  const double late = 3.0 - 0.5 * 0.012 * speed_of_sound(kReferenceCelsius);
  EXPECT_NEAR(run(walk).scans.firings.back().range_m, late, 0.05);
}

TEST(SimNuisances, CrosstalkIsHeardAsOftenAsAsked) {
  Walk walk = stand(200.0);
  const auto changed = [](const Firing& f) { return std::abs(f.range_m - 1.85) > 0.02; };
  walk.world.crosstalk = 0.5;
  EXPECT_GT(share(of_sensor(run(walk), 0), changed), 0.05);
  walk.world.crosstalk = 0.0;
  EXPECT_EQ(share(of_sensor(run(walk), 0), changed), 0.0);
}

TEST(SimNuisances, ClosingADoorShutsSoundOutFromThenOn) {
  Walk walk;
  walk.world = ideal_world();
  walk.start = {"hall", {4.0, 2.0}};
  walk.add(Pause{10.0});
  walk.add(SetDoor{"hall", "office", false});
  walk.add(Pause{10.0});
  for (const Firing& firing : of_sensor(run(walk), 0)) {
    EXPECT_NEAR(firing.range_m, firing.time_s < 10.0 ? 6.85 : 0.85, 0.07) << firing.time_s;
  }
}

TEST(SimNuisances, TheAirWarmsUp) {
  Walk walk = stand(600.0);
  walk.world.temperature_drift_k_per_min = 1.0;
  const std::vector<Firing> firings = of_sensor(run(walk), 0);
  const double expected = speed_of_sound(20.0) / speed_of_sound(30.0);
  EXPECT_NEAR(firings.back().range_m / firings.front().range_m, expected, 0.003);
}

TEST(SimNuisances, TheHeaderTellsTheTemperatureOnlyWithAThermometer) {
  Walk walk = stand(1.0);
  walk.world.temperature_c = 27.0;
  EXPECT_FALSE(run(walk).scans.belt.temperature_c.has_value());
  walk.world.thermometer = true;
  EXPECT_EQ(run(walk).scans.belt.temperature_c, 27.0);
}

}  // namespace
}  // namespace echoway::sim
