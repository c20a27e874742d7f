#include "tracker/understudy.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "echoway/sim/random_walk.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "plans/error_of.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"
#include "tracker/rows.hpp"

namespace echoway::tracker {
namespace {

using test::mean_of;
using test::row_in_two_places;
using test::row_of;

// How many firings of `gain` nats each in the understudy's favour it takes until the first verdict; 0: none for long.
int firings_until(Understudy::Verdict verdict, double gain) {
  Understudy understudy(4);
  for (int n = 1; n <= 1000; ++n) {
    const Understudy::Verdict now = understudy.judge(-2.0, -2.0 + gain);
    if (now != Understudy::Verdict::alike) return now == verdict ? n : 0;
  }
  return 0;
}

TEST(Understudy, BeginsWhereTheBeliefIs) {
  Understudy understudy(40);
  Random random(1);
  const Population belief = row_of(30);
  understudy.learn(belief, {}, 0, random);
  EXPECT_TRUE(understudy.present());
  EXPECT_EQ(understudy.population().size(), 30u);
  EXPECT_DOUBLE_EQ(mean_of(understudy.population().particles()), mean_of(belief.particles()));
}

TEST(Understudy, OfABeliefWithMoreParticlesThanItHasRoomForStandsForAllOfIt) {
  Understudy understudy(40);
  Random random(1);
  const Population belief = row_of(400);
  understudy.learn(belief, {}, 0, random);
  EXPECT_EQ(understudy.population().size(), 40u);
  EXPECT_NEAR(mean_of(understudy.population().particles()), mean_of(belief.particles()), 5.0);
}

TEST(Understudy, KeepsThePlacesOfTheBeliefApart) {
  Understudy understudy(40);
  Random random(1);
  understudy.learn(row_in_two_places(40, random), {}, 0, random);
  EXPECT_EQ(understudy.population().main_size(), 30u);
}

TEST(Understudy, OfABeliefThatItHasNoRoomForKeepsNoPlacesApart) {
  Understudy understudy(40);
  Random random(1);
  understudy.learn(row_in_two_places(40, random), {}, 0, random);
  understudy.learn(row_in_two_places(400, random), {}, 0, random);
  EXPECT_EQ(understudy.population().main_size(), 40u);
}

// The belief's doubts are its own until it has made something of the echoes by itself.
TEST(Understudy, FitsAsTheBeliefDoesWhereItBegins) {
  Understudy understudy(4);
  Random random(1);
  FitMonitor fit;
  for (int n = 0; n < 100; ++n) fit.observe(-4.0, true, 2.0);
  understudy.learn(row_of(4), fit, 100, random);
  EXPECT_TRUE(understudy.fit().poor());
}

// Who was lost is not called lost any more, and a search has to beat what explains the echoes now.
TEST(Understudy, BringsItsPlaceItsFitAndItsPastWhenItIsBelieved) {
  static History history;
  Random random(1);
  Understudy understudy(40);
  Population belief = row_of(30);
  FitMonitor fit;
  history.push({.log_main = -1.0, .log_second = -9.0});
  understudy.learn(row_of(20), fit, history.end(), random);
  history.push({.log_main = -4.0, .log_second = -0.5});
  for (int n = 0; n < 100; ++n) fit.observe(-4.0, true, 2.0);
  understudy.change_places(belief, fit, history, random);
  EXPECT_EQ(belief.size(), 20u);
  EXPECT_EQ(understudy.population().size(), 30u);
  EXPECT_FALSE(fit.poor());
  EXPECT_TRUE(understudy.fit().poor());
  EXPECT_EQ(history[0].log_main, -1.0) << "what they had in common";
  EXPECT_EQ(history[1].log_main, -0.5);
}

TEST(Understudy, ThatExplainsTheEchoesBetterIsBelievedWithinASecond) {
  EXPECT_GT(firings_until(Understudy::Verdict::ahead, 1.0), 3);
  EXPECT_LE(firings_until(Understudy::Verdict::ahead, 1.0), 16);
}

TEST(Understudy, IsGivenUpLaterThanTheBelief) {
  EXPECT_GT(firings_until(Understudy::Verdict::behind, -1.0), firings_until(Understudy::Verdict::ahead, 1.0));
}

TEST(Understudy, OfWhomNoSingleEchoDecides) {
  Understudy understudy(4);
  EXPECT_EQ(understudy.judge(-700.0, -1.0), Understudy::Verdict::alike);
  EXPECT_EQ(understudy.judge(-1.0, -700.0), Understudy::Verdict::alike);
}

TEST(Understudy, ThatIsNowBetterAndNowWorseStaysWhatItIs) {
  Understudy understudy(4);
  for (int n = 0; n < 1000; ++n) {
    EXPECT_EQ(understudy.judge(-2.0, n % 2 == 0 ? -1.0 : -3.0), Understudy::Verdict::alike);
  }
}

// What went before counts no more once it falls behind: a wearer may have been lost at any time.
TEST(Understudy, IsBelievedForWhatItHasExplainedOfLate) {
  Understudy understudy(4);
  for (int n = 0; n < 12; ++n) ASSERT_EQ(understudy.judge(-1.0, -2.0), Understudy::Verdict::alike);
  int firings = 1;
  while (understudy.judge(-2.0, -1.0) == Understudy::Verdict::alike && firings < 100) ++firings;
  EXPECT_EQ(firings, firings_until(Understudy::Verdict::ahead, 1.0));
}

TEST(Understudy, ThatBeginsAnewIsJudgedAnew) {
  Random random(1);
  Understudy understudy(4);
  for (int n = 1; n < firings_until(Understudy::Verdict::ahead, 1.0); ++n) {
    ASSERT_EQ(understudy.judge(-2.0, -1.0), Understudy::Verdict::alike);
  }
  understudy.learn(row_of(4), {}, 0, random);
  EXPECT_EQ(understudy.judge(-2.0, -1.0), Understudy::Verdict::alike);
}

TEST(Understudy, IsJudgedAnewAfterAVerdict) {
  Understudy understudy(4);
  for (int n = 1; n <= firings_until(Understudy::Verdict::ahead, 1.0); ++n) {
    static_cast<void>(understudy.judge(-2.0, -1.0));
  }
  EXPECT_EQ(understudy.judge(-2.0, -1.0), Understudy::Verdict::alike);
}

// Ends of the way of an estimate through a walk, with an understudy and without.
struct Ends {
  Estimate with, without;

  [[nodiscard]] bool same() const noexcept {
    return with.pose.position == without.pose.position && with.pose.heading == without.pose.heading;
  }
};

// A walk of twelve seconds through which the phone's motion sensors say nothing from second `quiet` on, for so long.
Ends walk_twice(double quiet, double seconds) {
  const Building building = test::small_office();
  sim::RandomWalkOptions options;
  options.duration_s = 12.0;
  auto walk = sim::simulate(building, sim::random_walk(building, options, 5));
  EXPECT_TRUE(walk.ok());
  const double begin = walk->scans.firings.front().time_s + quiet;
  std::erase_if(walk->motion, [&](const MotionHint& h) { return h.time_s >= begin && h.time_s < begin + seconds; });
  const auto end = [&](bool understudy) {
    BayesOptions bayes;
    bayes.parts.understudy = understudy;
    BayesLocator locator(building, {}, test::start_of(*walk, building), bayes);
    test::play(*walk, locator, [](std::size_t) {});
    return locator.estimate();
  };
  return {end(true), end(false)};
}

TEST(Understudy, IsLeftOutWhereAGyroscopeTellsTheTurns) { EXPECT_TRUE(walk_twice(0.0, 0.0).same()); }

TEST(Understudy, IsNoneInAGapOfTheGyroscopesReadings) { EXPECT_TRUE(walk_twice(4.0, 1.5).same()); }

TEST(Understudy, IsFollowedOnceTheGyroscopeIsAway) {
  EXPECT_FALSE(walk_twice(4.0, 4.0).same());
  const Ends blind = walk_twice(0.0, 60.0);
  EXPECT_FALSE(blind.same());
  EXPECT_LT(distance(blind.with.pose.position, blind.without.pose.position), 1.0);
}

// Mean distance in metres from where the wearer is, over a walk without motion hints.
double mean_error_of(Locator& locator, const Building& building, const sim::Simulation& walk) {
  double sum = 0.0;
  const auto add = [&](std::size_t i) { sum += plans::error_of(locator.estimate(), walk.truth[i], building); };
  test::play(walk, locator, add, false);
  return sum / static_cast<double>(walk.scans.firings.size());
}

// The same of many draws of a few walks, by so few particles that a turn is missed now and then; nobody is searched
// for.
double mean_error_of_draws(bool understudy) {
  constexpr std::uint64_t kWalks = 6, kDraws = 6;
  const Building building = test::small_office();
  BayesOptions bayes;
  bayes.particles_without_gyroscope = 80;
  bayes.parts.understudy = understudy;
  bayes.parts.recovery = false;
  sim::RandomWalkOptions options;
  options.duration_s = 15.0;
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kWalks; ++seed) {
    const auto walk = *sim::simulate(building, sim::random_walk(building, options, seed));
    for (bayes.seed = 1; bayes.seed <= kDraws; ++bayes.seed) {
      BayesLocator locator(building, {}, test::start_of(walk, building), bayes);
      sum += mean_error_of(locator, building, walk);
    }
  }
  return sum / static_cast<double>(kWalks * kDraws);
}

TEST(Understudy, HelpsWhoMissedATurnWithoutAGyroscope) {
  const double alone = mean_error_of_draws(false);
  const double helped = mean_error_of_draws(true);
  RecordProperty("alone_m", std::to_string(alone));
  RecordProperty("helped_m", std::to_string(helped));
  EXPECT_LT(helped, 0.8 * alone);
}

}  // namespace
}  // namespace echoway::tracker
