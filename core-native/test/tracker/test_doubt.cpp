// Whoever leads a wearer may doubt the place; here they were told to start at the wrong one of two that look the same.
#include <gtest/gtest.h>

#include <algorithm>
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

/// How likely the other level of two that are alike is, some seconds after the wearer was told to go there and the
/// guide has come to doubt that they are still before the stairs.
double elsewhere(std::uint64_t seed, bool doubted) {
  sim::RandomWalkOptions options;
  options.duration_s = 30.0;
  const Building lower = test::plain_hall();
  const auto walk = sim::simulate(lower, sim::random_walk(lower, options, seed));
  if (!walk) return -1.0;
  Building building = lower;
  building.rooms.push_back(lower.rooms.front());
  building.rooms.back().id = "upper hall";
  building.rooms.back().level = 1;
  std::size_t told_at = 0;
  while (walk->scans.firings[told_at].time_s < kDoubted) ++told_at;
  const Vec2 stairs = walk->truth[told_at].pose.position;
  building.links.push_back({LevelLinkKind::stairs, 0, stairs, 1, stairs});
  const Pose2 begin = walk->truth.front().pose;
  BayesLocator locator(building, {}, {0, begin.position, begin.heading});
  locator.on_led(true);
  double likeliest = 0.0;
  test::play(*walk, locator, [&](std::size_t i) {
    if (i == told_at && doubted) {
      locator.on_level_transition({0, 0, 1, walk->scans.firings[i].time_s, 45.0});
      locator.on_doubt();
    }
    double upper = 0.0;
    for (const Hypothesis& h : locator.hypotheses()) upper += h.room == 1 ? h.probability : 0.0;
    if (i >= told_at) likeliest = std::max(likeliest, upper);
  });
  return likeliest;
}

TEST(Doubt, OfWhoFindsNoStairsToTakeIsThatTheyHaveTakenThem) {
  int believed = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    believed += elsewhere(seed, true) > 0.5 ? 1 : 0;
    EXPECT_LT(elsewhere(seed, false), 0.2);
  }
  EXPECT_GE(believed, 6) << "of 8 walks; what stands in no plan may speak against one";
}

}  // namespace
}  // namespace echoway
