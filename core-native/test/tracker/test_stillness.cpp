#include "tracker/stillness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "echoway/building/loader.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "echoway/units.hpp"
#include "tracker/plans.hpp"
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

// A wearer in the middle of a long hall that says nothing of the way along it, cupboards farther on that stand in no
// plan, and a phone that counts no steps.
class HallWithCupboards : public ::testing::Test {
 protected:
  static constexpr double kWidth = 2.4, kCupboards = 15.0, kFrom = 10.0;
  static constexpr double kStops = 6.0, kEnds = 9.0;   // Seconds.
  BeltConfig belt_;
  Building hall_;

  HallWithCupboards() {
    hall_.rooms.push_back(test::room_from_outline("hall", {{0, 0}, {40, 0}, {40, kWidth}, {0, kWidth}}));
  }

  double heard(int sensor, double x) const {
    const double bearing = wrap_angle(belt_.bearing(sensor));
    if (std::abs(bearing) < degrees(60.0)) return (kCupboards - x) / std::cos(bearing) - belt_.radius_m;
    const bool beside = std::abs(std::abs(bearing) - 0.5 * kPi) < degrees(13.0);
    return beside ? 0.5 * kWidth - belt_.radius_m : Firing::kNoEcho;
  }
};

TEST_F(HallWithCupboards, TellsThatTheWearerHasStopped) {
  BayesLocator locator(hall_, belt_, {.room = 0, .position = Vec2{kFrom, 0.5 * kWidth}, .heading = 0.0}, {});
  double farthest_on = 0.0, x = kFrom;
  for (int i = 0; i * 0.0624 < kEnds; ++i) {
    const double time = i * 0.0624;
    x = kFrom + kPace * std::min(time, kStops);
    const int sensor = i % belt_.sensors;
    locator.on_motion({time, MotionKind::yaw_rate, 0.0});
    locator.on_firing({time, sensor, heard(sensor, x)});
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
    const auto ride = *sim::simulate(building, walk);
    BayesLocator locator(building, ride.scans.belt.apply_to({}), test::start_of(ride, building), {});
    test::play(ride, locator, [](std::size_t) {});
    EXPECT_EQ(locator.estimate().room, building.find_room("1-room-3")) << "ride " << seed;
  }
}

}  // namespace
}  // namespace echoway::tracker
