#include "tracker/dead_reckoning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "echoway/units.hpp"
#include "tracker/motion.hpp"

namespace echoway::tracker {
namespace {

constexpr double kArea = 300.0;   // m2

DeadReckoning reckoning_after(double metres) {
  DeadReckoning reckoning;
  reckoning.begin({2, {1.0, 1.0}, 0.0});
  for (int i = 0; i < 10; ++i) reckoning.move(0.0, 0.1 * metres);
  return reckoning;
}

TEST(DeadReckoning, LeadsAroundACornerWithWhoeverWalks) {
  DeadReckoning reckoning = reckoning_after(3.0);
  reckoning.move(degrees(90.0), 0.0);
  reckoning.move(0.0, 2.0);
  EXPECT_EQ(reckoning.at().level, 2);
  EXPECT_NEAR(reckoning.at().position.x, 4.0, 1e-9);
  EXPECT_NEAR(reckoning.at().position.y, 3.0, 1e-9);
  EXPECT_NEAR(reckoning.at().heading, degrees(90.0), 1e-9);
}

TEST(DeadReckoning, TellsLikeOfficesApartAfterAFewSteps) {
  const DeadReckoning reckoning = reckoning_after(2.0);
  const double next_office = reckoning.log_prior({2, {7.0, 1.0}, 0.0}, kArea);
  EXPECT_GT(reckoning.log_prior({2, {3.0, 1.0}, 0.0}, kArea), next_office + 5.0);
}

TEST(DeadReckoning, IsBelievedLessTheLongerTheWay) {
  const auto gain = [](double way) {
    const DeadReckoning reckoning = reckoning_after(way);
    const auto prior_at = [&](double x) { return reckoning.log_prior({2, {x, 1.0}, 0.0}, kArea); };
    return prior_at(1.0 + way) - prior_at(4.0 + way);
  };
  EXPECT_GT(gain(0.0), gain(5.0));
  EXPECT_GT(gain(5.0), gain(20.0));
}

TEST(DeadReckoning, KnowsWhichWayTheWearerFaces) {
  const DeadReckoning reckoning = reckoning_after(2.0);
  EXPECT_GT(reckoning.log_prior({2, {3.0, 1.0}, 0.0}, kArea), reckoning.log_prior({2, {3.0, 1.0}, kPi}, kArea) + 5.0);
}

TEST(DeadReckoning, LeavesPlacesToWhichSomebodyWasCarriedPossible) {
  const DeadReckoning reckoning = reckoning_after(2.0);
  EXPECT_GT(reckoning.log_prior({2, {60.0, -30.0}, 2.0}, kArea), std::log(1e-3));
  EXPECT_GT(reckoning.log_prior({0, {3.0, 1.0}, 0.0}, kArea), std::log(1e-3));
}

TEST(DeadReckoning, CountsStepsButNotThoseOfATurnOnTheSpot) {
  const auto counted = [](double yaw_rate) {
    HintIntegrator hints;
    for (int i = 0; i < 100; ++i) {
      hints.on_hint({0.1 * i, MotionKind::yaw_rate, yaw_rate});
      if (i % 6 == 0) hints.on_hint({0.1 * i, MotionKind::step, 1.0});
    }
    return hints.close(10.0, 1.0).steps;
  };
  EXPECT_NEAR(counted(0.0), 17.0, 0.5);
  EXPECT_LT(counted(degrees(90.0)), 4.0);
}

}  // namespace
}  // namespace echoway::tracker
