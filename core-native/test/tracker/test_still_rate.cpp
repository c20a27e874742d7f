#include "tracker/still_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "echoway/geometry/pose2.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/plans.hpp"

namespace echoway {
namespace {

using tracker::StillRate;

TEST(StillRate, TakesTheMeanOfASecondInWhichNobodyTurnsOrSteps) {
  StillRate rate;
  for (int i = 0; i <= 30; ++i) rate.note(0.04 * i, degrees(i % 2 == 0 ? 0.9 : 1.1), false);
  const auto mean = rate.take();
  ASSERT_TRUE(mean);
  EXPECT_NEAR(*mean, degrees(1.0), degrees(0.01));
  EXPECT_FALSE(rate.take()) << "it is said once";
}

TEST(StillRate, SaysNothingOfWhoTurnsWalksOrWhosePhoneSleeps) {
  StillRate turning, walking, sleeping;
  for (int i = 0; i <= 50; ++i) {
    turning.note(0.04 * i, i % 20 == 0 ? degrees(12.0) : degrees(0.5), false);
    walking.note(0.04 * i, degrees(0.5), true);
    sleeping.note(0.5 * i, degrees(0.5), false);
  }
  EXPECT_FALSE(turning.take());
  EXPECT_FALSE(walking.take());
  EXPECT_FALSE(sleeping.take());
}

// The heading of one who waits for half a minute without an echo: nothing but the gyroscope tells of it.
double heading_after_waiting(double rate, std::uint64_t seed) {
  const Building building = test::small_office();
  Start start;
  start.room = 1;
  start.position = Vec2{1.5, 1.5};
  start.heading = 0.0;
  BayesOptions options;
  options.seed = seed;
  BayesLocator locator(building, {}, start, options);
  int hint = 0;
  for (int i = 0; i < 480; ++i) {
    const double now = 0.0624 * i;
    for (; 0.04 * hint <= now; ++hint) locator.on_motion({0.04 * hint, MotionKind::yaw_rate, rate});
    locator.on_firing({now, i % 15, Firing::kNoEcho});
  }
  return locator.estimate().pose.heading;
}

TEST(StillRate, KeepsTheHeadingOfAWaitingWearerWhoseGyroscopeDrifts) {
  constexpr int kWearers = 8;
  double off = 0.0;
  for (int seed = 1; seed <= kWearers; ++seed) off += std::abs(heading_after_waiting(degrees(1.0), seed)) / kWearers;
  EXPECT_LT(off, degrees(15.0)) << "the gyroscope turned by 30";
}

}  // namespace
}  // namespace echoway
