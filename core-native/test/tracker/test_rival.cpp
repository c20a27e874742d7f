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

constexpr double kFits = 0.8;    // Nats a firing over no place at all: a right place among furniture.
constexpr double kHardly = 0.1;

// How many firings it takes until `gain` nats each, in the rival's favour, decide; 0 when it stays undecided for long.
int firings_until(Rival::Verdict verdict, Rival rival, double gain, Rival::Belief belief, double fit) {
  for (int n = 1; n <= 1000; ++n) {
    const Rival::Verdict now = rival.judge({-2.0, -2.0 + gain, fit}, belief);
    if (now == verdict) return n;
    if (now != Rival::Verdict::undecided) return 0;
  }
  return 0;
}

int firings_until(Rival::Verdict verdict, double log_odds, double gain, Rival::Belief belief = Rival::Belief::proved,
                  double fit = kFits) {
  return firings_until(verdict, rival_with(log_odds), gain, belief, fit);
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
  const int hurried = firings_until(Rival::Verdict::rejected, -20.0, 0.0, Rival::Belief::poor);
  EXPECT_GT(hurried, 32);
  EXPECT_LT(hurried, patient);
  EXPECT_LT(firings_until(Rival::Verdict::rejected, -20.0, -1.0, Rival::Belief::poor), 16);
}

TEST(Rival, ThatGainsSlowlyOnAPoorBeliefIsNotDismissedForItsAge) {
  constexpr double kSlow = 0.15;
  EXPECT_GT(firings_until(Rival::Verdict::rejected, -20.0, kSlow), 0);
  EXPECT_GT(firings_until(Rival::Verdict::accepted, -20.0, kSlow, Rival::Belief::poor), 0);
}

TEST(Rival, ThatIsRightIsBelievedAgainstAPoorBeliefToo) {
  EXPECT_EQ(firings_until(Rival::Verdict::accepted, -20.0, 0.5, Rival::Belief::poor),
            firings_until(Rival::Verdict::accepted, -20.0, 0.5));
}

// Among people and things that no plan knows the right place explains hardly more than no place would, and some wrong
// one is better for a while.
TEST(Rival, ThatExplainsLittleMustBeBetterForLonger) {
  for (const Rival::Belief belief : {Rival::Belief::proved, Rival::Belief::poor}) {
    const int fitting = firings_until(Rival::Verdict::accepted, -7.0, 0.5, belief);
    const int hardly = firings_until(Rival::Verdict::accepted, -7.0, 0.5, belief, kHardly);
    EXPECT_GT(fitting, 0);
    EXPECT_GT(hardly, 2 * fitting);
  }
}

TEST(Rival, OfAFirstFindNeedsOnlyBeBetter) {
  constexpr auto kUnproved = Rival::Belief::unproved;
  EXPECT_EQ(firings_until(Rival::Verdict::accepted, -2.0, 0.5, kUnproved, kHardly),
            firings_until(Rival::Verdict::accepted, -2.0, 0.5, kUnproved));
}

TEST(Rival, ThatWasBelievedBeforeNeedsOnlyBeBetter) {
  Rival returning = rival_with(0.0);
  returning.begin_return(-7.0);
  EXPECT_EQ(firings_until(Rival::Verdict::accepted, returning, 0.5, Rival::Belief::poor, kHardly),
            firings_until(Rival::Verdict::accepted, returning, 0.5, Rival::Belief::poor, kFits));
}

}  // namespace
}  // namespace echoway::tracker
