#include "tracker/range_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "echoway/tracker/bayes_locator.hpp"
#include "echoway/units.hpp"
#include "tracker/hall_with_cupboards.hpp"

namespace echoway::tracker {
namespace {

constexpr double kPass = 1.0;    // Seconds.
constexpr double kPace = 0.55;   // m/s.

// What the ranges of two echoes a second apart tell, heard `bearing` off the heading.
std::optional<SpeedReading> told_by(double first, double second, double bearing = 0.0) {
  return speed_by_range_rate({kPass, first, second}, {std::cos(bearing), std::sin(bearing)}, kPace);
}

TEST(RangeRate, TellsHowFastTheWearerComesNearer) {
  const auto ahead = told_by(3.0, 2.5);
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(ahead->speed, 0.5, 1e-12);
  const auto behind = told_by(1.0, 1.5, kPi);
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->speed, 0.5, 1e-12);
}

TEST(RangeRate, TellsLessOfWhatIsFarOrToOneSide) {
  const double near = told_by(1.5, 1.0)->variance;
  EXPECT_GT(near, 0.05 * 0.05) << "a trunk sways with each step, however near things are";
  EXPECT_GT(told_by(6.5, 6.0)->variance, 1.5 * near);
  EXPECT_GT(told_by(1.5, 1.0, degrees(48.0))->variance, 1.5 * near);
}

TEST(RangeRate, TellsNothingOfWhatIsBesideTheWearer) {
  EXPECT_FALSE(told_by(1.5, 1.0, degrees(72.0)));
  EXPECT_FALSE(told_by(1.5, 1.0, degrees(-96.0)));
}

TEST(RangeRate, TellsNothingWhereNobodyWalks) {
  EXPECT_FALSE(told_by(2.0, 2.0)) << "standing is told elsewhere";
  EXPECT_FALSE(told_by(2.0, 1.85)) << "who shuffles is as good as standing";
  EXPECT_FALSE(told_by(2.0, 2.5)) << "nobody walks backwards for long";
  EXPECT_FALSE(told_by(5.0, 2.0)) << "too fast for anybody";
  EXPECT_FALSE(told_by(0.8, 0.3)) << "an arm";
}

TEST(RangeRate, IsFiniteOrNothingForAnyPair) {
  for (const double seconds : {1e-300, 1e-9, 1.0, 1.5}) {
    for (const double range : {0.0, 0.5, 10.7, 1e300}) {
      for (const double before : {0.0, 0.5, 10.7, 1e300}) {
        const auto told = speed_by_range_rate({seconds, before, range}, {1.0, 0.0}, kPace);
        EXPECT_TRUE(!told || (std::isfinite(told->speed) && std::isfinite(told->variance) && told->variance > 0.0));
      }
    }
  }
}

// One who is thought to walk at 0.6 m/s, give or take 0.1, and to have come so far.
Particle walker() {
  Particle p;
  p.weight = 1.0;
  p.gait = Gait::walking;
  p.speed = 0.6;
  p.cov.xx = p.cov.yy = p.cov.ss = 0.01;
  p.cov.xs = 0.005;
  return p;
}

TEST(RangeRate, ChangesSpeedAndTheWayThatWasWalkedWithIt) {
  Particle p = walker();
  const double factor = heed(p, {0.5, 0.0025}, 1.0);
  EXPECT_LT(p.speed, 0.55);
  EXPECT_GT(p.speed, 0.5);
  EXPECT_LT(p.position.x, -0.01);
  EXPECT_LT(p.cov.ss, 0.005);
  EXPECT_GT(factor, 1.0) << "who stands would not have heard that";
}

TEST(RangeRate, CountsForAsMuchAsThePlanDoesNotExplain) {
  Particle half = walker(), whole = walker();
  const double factor = heed(half, {0.5, 0.0025}, 0.5);
  EXPECT_GT(half.speed, 0.52);
  EXPECT_LT(half.speed, 0.6);
  EXPECT_LT(factor, heed(whole, {0.5, 0.0025}, 1.0));
}

TEST(RangeRate, LeavesAGaussianHoweverOftenItIsHeard) {
  Particle p = walker();
  for (int i = 0; i < 1000; ++i) EXPECT_GT(heed(p, {0.6, 0.0025}, 1.0), 0.0);
  EXPECT_GT(p.cov.ss, 0.0);
  EXPECT_GT(p.cov.xx * p.cov.ss - p.cov.xs * p.cov.xs, 0.0);
}

TEST(RangeRate, OfAnotherThingIsNotTakenForTheWearers) {
  Particle p = walker();
  const double factor = heed(p, {1.4, 0.0025}, 1.0);
  EXPECT_EQ(p.speed, 0.6);
  EXPECT_LT(factor, 1.0);
  EXPECT_GT(factor, 0.5) << "which happens";
}

// Nobody's steps are heard. How far from the truth who walks slowly is at the end, metres.
double off_after_a_slow_walk(std::uint64_t seed, bool range_rate, bool gyroscope = true) {
  constexpr double kFrom = 8.0, kSpeed = 0.35, kEnds = 12.0;
  const test::HallWithCupboards hall;
  const Building plan = hall.plan();
  BayesOptions options{.seed = seed};
  options.parts.range_rate = range_rate;
  const Start start{.room = 0, .position = Vec2{kFrom, 0.5 * hall.kWidth}, .heading = 0.0};
  BayesLocator locator(plan, hall.belt, start, options);
  double x = kFrom;
  for (int i = 0; i * hall.belt.slot_s < kEnds; ++i) {
    const double time = i * hall.belt.slot_s;
    x = kFrom + kSpeed * time;
    const int sensor = i % hall.belt.sensors;
    if (gyroscope) locator.on_motion({time, MotionKind::yaw_rate, 0.0});
    locator.on_firing({time, sensor, hall.heard(sensor, x)});
  }
  return std::abs(locator.estimate().pose.position.x - x);
}

TEST(RangeRate, KeepsWhoWalksSlowlyFromRunningAhead) {
  double without = 0.0, with = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    without += off_after_a_slow_walk(seed, false);
    with += off_after_a_slow_walk(seed, true);
  }
  EXPECT_LT(with, 0.7 * without);
}

TEST(RangeRate, IsNotToldWithoutAGyroscope) {
  EXPECT_EQ(off_after_a_slow_walk(1, true, false), off_after_a_slow_walk(1, false, false))
      << "nobody knows whether the sensor looks the same way";
}

}  // namespace
}  // namespace echoway::tracker
