#include "tracker/stillness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "echoway/building/loader.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/hall_with_cupboards.hpp"
#include "tracker/play.hpp"

namespace echoway::tracker {
namespace {

constexpr double kPace = 0.5;           // m/s.

// What the second of two echoes of a sensor, a pass apart, tells.
double told_by(double first, double second) { return stillness({15 * 0.0624, first, second}, kPace); }

TEST(Stillness, IsToldByAnEchoThatRepeatsTheLast) {
  EXPECT_GT(told_by(2.0, 2.01), 1.5);
  EXPECT_GT(told_by(6.0, 6.05), 1.2) << "far things are heard less exactly";
}

TEST(Stillness, IsDeniedByOneThatHasChangedByWhatAWearerWalks) {
  EXPECT_LT(told_by(2.0, 1.6), 0.6);
  EXPECT_LT(told_by(2.0, 2.4), 0.6);
}

TEST(Stillness, IsFiniteForAnyRange) {
  for (const double second : {0.01, 10.7, 1e6, 1e300}) {
    const double odds = told_by(2.0, second);
    EXPECT_TRUE(std::isfinite(odds) && odds > 0.0) << second;
  }
}

// The phone counts no steps.
TEST(Stillness, TellsThatTheWearerHasStopped) {
  constexpr double kFrom = 10.0;
  constexpr double kStops = 6.0, kEnds = 9.0;   // Seconds.
  const test::HallWithCupboards hall;
  const Building plan = hall.plan();
  const Start start{.room = 0, .position = Vec2{kFrom, 0.5 * hall.kWidth}, .heading = 0.0};
  BayesLocator locator(plan, hall.belt, start, {});
  double farthest_on = 0.0;
  for (int i = 0; i * 0.0624 < kEnds; ++i) {
    const double time = i * 0.0624;
    const double x = kFrom + kPace * std::min(time, kStops);
    const int sensor = i % hall.belt.sensors;
    locator.on_motion({time, MotionKind::yaw_rate, 0.0});
    locator.on_firing({time, sensor, hall.heard(sensor, x)});
    if (time > kStops + 2.0) farthest_on = std::max(farthest_on, locator.estimate().speed_mps);
  }
  EXPECT_LT(farthest_on, 0.15) << "m/s, two seconds after they stopped";
}

// A cabin's walls repeat themselves, too, and stand in no plan: that is no reason to think that who rides in it stands
// before its door.
TEST(Stillness, IsThatOfAnElevatorsRidersAsWell) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/westport-house");
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    sim::Walk walk;
    walk.seed = seed;
    walk.start = {"g-room-3", {11.5, 11.0}};
    walk.world = sim::make_world(sim::Profile::furnished);
    walk.add(sim::GoTo{{"1-room-3", {43.0, 58.5}}});
    walk.add(sim::GoTo{{"1-room-3", {46.0, 58.5}}});
    EXPECT_EQ(test::room_at_the_end(building, walk), building.find_room("1-room-3")) << "ride " << seed;
  }
}

}  // namespace
}  // namespace echoway::tracker
