// Whoever leads a wearer may doubt the place; here they were told to start at the wrong one of two that look the same.
#include <gtest/gtest.h>

#include <utility>

#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/likely.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"

namespace echoway {
namespace {

constexpr double kDoubted = 15.0;  // s
using test::kFarCorner;

/// Whether the true place is ever among the likely ones after kDoubted; or, with `keeps`, the place that was told.
bool is_considered(std::uint64_t seed, bool doubted, bool keeps = false) {
  const Building building = test::plain_hall();
  sim::RandomWalkOptions options;
  options.duration_s = 30.0;
  const auto walk = sim::simulate(building, sim::random_walk(building, options, seed));
  if (!walk) return false;
  const Pose2 begin = walk->truth.front().pose;
  BayesLocator locator(building, {}, {0, kFarCorner - begin.position, wrap_angle(begin.heading + kPi)});
  bool told = false, considered = false;
  test::play(*walk, locator, [&](std::size_t i) {
    if (walk->scans.firings[i].time_s < kDoubted) return;
    if (doubted && !std::exchange(told, true)) locator.on_doubt();
    const Vec2 here = keeps ? kFarCorner - walk->truth[i].pose.position : walk->truth[i].pose.position;
    considered = considered || test::is_likely(locator.hypotheses(), here);
  });
  return considered;
}

int considered(bool doubted, bool keeps = false) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) count += is_considered(seed, doubted, keeps) ? 1 : 0;
  return count;
}

TEST(Doubt, BringsThePlaceThatLooksTheSameToMind) {
  const int doubted = considered(true);
  EXPECT_GE(doubted, 5);
  EXPECT_LT(considered(false), doubted) << "the test would say nothing";
}

TEST(Doubt, IsNoReasonToForgetWhereTheWearerWasTakenToBe) { EXPECT_GE(considered(true, true), 5); }

}  // namespace
}  // namespace echoway
