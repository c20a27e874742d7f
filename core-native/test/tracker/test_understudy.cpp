#include "tracker/understudy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "echoway/sim/random_walk.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "plans/error_of.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"

namespace echoway::tracker {
namespace {

// A belief of so many particles that are sure to be in a row, a metre apart, of weights that grow along it.
Population row_of(std::size_t particles) {
  Population row(particles);
  for (std::size_t i = 0; i < particles; ++i) {
    Particle p;
    p.position.x = static_cast<double>(i);
    p.weight = static_cast<double>(i + 1);
    row.push(p);
  }
  row.normalize();
  return row;
}

double mean_of(std::span<const Particle> particles) {
  double mean = 0.0, sum = 0.0;
  for (const Particle& p : particles) {
    mean += p.weight * p.position.x;
    sum += p.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  return mean;
}

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
  understudy.learn(belief, random);
  EXPECT_TRUE(understudy.present());
  EXPECT_EQ(understudy.population().size(), 30u);
  EXPECT_DOUBLE_EQ(mean_of(understudy.population().particles()), mean_of(belief.particles()));
}

TEST(Understudy, OfABeliefWithMoreParticlesThanItHasRoomForStandsForAllOfIt) {
  Understudy understudy(40);
  Random random(1);
  const Population belief = row_of(400);
  understudy.learn(belief, random);
  EXPECT_EQ(understudy.population().size(), 40u);
  EXPECT_NEAR(mean_of(understudy.population().particles()), mean_of(belief.particles()), 5.0);
}

// The same in two places, of which the farther one has three quarters of the particles.
Population two_places_of(std::size_t particles, Random& random) {
  Population belief = row_of(particles);
  std::vector<std::uint8_t> place(particles, 1);
  std::fill_n(place.begin(), particles / 4, std::uint8_t{0});
  belief.resample(place, std::array{particles / 4, particles - particles / 4}, random);
  return belief;
}

TEST(Understudy, KeepsThePlacesOfTheBeliefApart) {
  Understudy understudy(40);
  Random random(1);
  understudy.learn(two_places_of(40, random), random);
  EXPECT_EQ(understudy.population().main_size(), 30u);
}

TEST(Understudy, OfABeliefThatItHasNoRoomForKeepsNoPlacesApart) {
  Understudy understudy(40);
  Random random(1);
  understudy.learn(two_places_of(40, random), random);
  understudy.learn(two_places_of(400, random), random);
  EXPECT_EQ(understudy.population().main_size(), 40u);
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
  understudy.learn(row_of(4), random);
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
};

Ends walk_twice(bool hints) {
  const Building building = test::small_office();
  sim::RandomWalkOptions options;
  options.duration_s = 12.0;
  const auto walk = sim::simulate(building, sim::random_walk(building, options, 5));
  EXPECT_TRUE(walk.ok());
  const auto end = [&](bool understudy) {
    BayesOptions bayes;
    bayes.parts.understudy = understudy;
    BayesLocator locator(building, {}, test::start_of(*walk, building), bayes);
    test::play(*walk, locator, [](std::size_t) {}, hints);
    return locator.estimate();
  };
  return {end(true), end(false)};
}

TEST(Understudy, IsLeftOutWhereAGyroscopeTellsTheTurns) {
  const Ends guided = walk_twice(true);
  EXPECT_EQ(guided.with.pose.position.x, guided.without.pose.position.x);
  EXPECT_EQ(guided.with.pose.heading, guided.without.pose.heading);
  const Ends blind = walk_twice(false);
  EXPECT_NE(blind.with.pose.position.x, blind.without.pose.position.x);
  EXPECT_NEAR(blind.with.pose.position.x, blind.without.pose.position.x, 1.0);
}

// Mean distance in metres from where the wearer is, over a walk without motion hints.
double mean_error_of(Locator& locator, const Building& building, const sim::Simulation& walk) {
  double sum = 0.0;
  const auto add = [&](std::size_t i) { sum += plans::error_of(locator.estimate(), walk.truth[i], building); };
  test::play(walk, locator, add, false);
  return sum / static_cast<double>(walk.scans.firings.size());
}

// How often the wearer of one of a few walks is lost for a while by the luck of the draw: few particles miss a turn
// often, and nobody is searched for.
int times_lost(bool understudy) {
  constexpr double kLost = 0.4;   // Metres, in the mean of a walk.
  constexpr std::uint64_t kDraws = 10;
  const Building building = test::small_office();
  BayesOptions bayes;
  bayes.particles_without_gyroscope = 40;
  bayes.parts.understudy = understudy;
  bayes.parts.recovery = false;
  sim::RandomWalkOptions options;
  options.duration_s = 20.0;
  int lost = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto walk = *sim::simulate(building, sim::random_walk(building, options, seed));
    for (bayes.seed = 1; bayes.seed <= kDraws; ++bayes.seed) {
      BayesLocator locator(building, {}, test::start_of(walk, building), bayes);
      lost += mean_error_of(locator, building, walk) > kLost;
    }
  }
  return lost;
}

TEST(Understudy, HelpsWhoMissedATurnWithoutAGyroscope) {
  const int alone = times_lost(false);
  const int helped = times_lost(true);
  RecordProperty("alone", alone);
  RecordProperty("helped", helped);
  EXPECT_LT(3 * helped, alone);
}

}  // namespace
}  // namespace echoway::tracker
