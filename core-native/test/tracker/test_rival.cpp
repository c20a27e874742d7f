#include "tracker/rival.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

Rival rival_with(double log_odds) {
  Rival rival(4);
  Particle p;
  p.weight = 1.0;
  rival.population().push(p);
  rival.begin(log_odds);
  return rival;
}

// How many firings it takes until `gain` nats each, in the rival's favour, decide; 0 when it stays undecided for long.
int firings_until(Rival::Verdict verdict, double log_odds, double gain, bool belief_poor = false) {
  Rival rival = rival_with(log_odds);
  for (int n = 1; n <= 1000; ++n) {
    const Rival::Verdict now = rival.judge(-2.0, -2.0 + gain, belief_poor);
    if (now == verdict) return n;
    if (now != Rival::Verdict::undecided) return 0;
  }
  return 0;
}

TEST(Rival, ThatExplainsEveryFiringBetterIsBelievedWithinSeconds) {
  EXPECT_GT(firings_until(Rival::Verdict::accepted, -7.0, 1.0), 5);
  EXPECT_LE(firings_until(Rival::Verdict::accepted, -7.0, 1.0), 16);
}

TEST(Rival, FromAfarMustProveItselfLonger) {
  EXPECT_GT(firings_until(Rival::Verdict::accepted, -20.0, 1.0), firings_until(Rival::Verdict::accepted, -7.0, 1.0));
}

TEST(Rival, ThatExplainsNothingBetterIsDismissedInTheEnd) {
  EXPECT_GT(firings_until(Rival::Verdict::rejected, -3.0, 0.0), 0);
  EXPECT_GT(firings_until(Rival::Verdict::rejected, -3.0, -1.0), 0);
  EXPECT_LT(firings_until(Rival::Verdict::rejected, -3.0, -1.0), firings_until(Rival::Verdict::rejected, -3.0, 0.0));
}

TEST(Rival, ThatIsNoBetterThanAPoorBeliefMakesRoomForTheNextSearchWithinSeconds) {
  const int patient = firings_until(Rival::Verdict::rejected, -20.0, 0.0);
  const int hurried = firings_until(Rival::Verdict::rejected, -20.0, 0.0, true);
  EXPECT_GT(hurried, 32);
  EXPECT_LT(hurried, patient);
  EXPECT_LT(firings_until(Rival::Verdict::rejected, -20.0, -1.0, true), 16);
}

TEST(Rival, ThatGainsSlowlyOnAPoorBeliefIsNotDismissedForItsAge) {
  constexpr double kSlow = 0.15;
  EXPECT_GT(firings_until(Rival::Verdict::rejected, -20.0, kSlow), 0);
  EXPECT_GT(firings_until(Rival::Verdict::accepted, -20.0, kSlow, true), 0);
}

TEST(Rival, ThatIsRightIsBelievedAgainstAPoorBeliefToo) {
  EXPECT_EQ(firings_until(Rival::Verdict::accepted, -20.0, 0.5, true),
            firings_until(Rival::Verdict::accepted, -20.0, 0.5));
}

}  // namespace
}  // namespace echoway::tracker
