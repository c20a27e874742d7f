#include "tracker/refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tracker/plans.hpp"
#include "tracker/searching.hpp"

namespace echoway::tracker {
namespace {

constexpr double kAside = 0.8;  // Metres from the wall beside: the one on the right, or the one on the left.
constexpr Vec2 kHere{1.5, kAside};
constexpr Vec2 kThere{1.5, test::kFarCorner.y - kAside};
constexpr int kAhead = 0, kLeft = 4;  // Sensors.

constexpr int kParticles = 400;

/// How many particles were drawn where nobody stands, by who knew so many firings from the first on.
struct Drawn {
  int there = kParticles / 2;
  std::uint64_t foreseen = 0;
};

class RefinementTest : public SearchingTest {
 protected:
  RefinementTest() : SearchingTest(test::plain_hall()) {}

  void hear(int sensor, double to_wall) {
    Record record = record_of(sensor);
    record.echo = true;
    record.range = to_wall - belt_.radius_m;
    history_.push(record);
  }

  /// Of those particles, once all have caught up.
  double weight_of(Refinement& refinement, bool (*is_one)(const Particle&)) {
    while (!refinement.work(tools(), random_, 10000, 1)) {
    }
    double weight = 0.0;
    for (const Particle& p : refinement.population().particles()) weight += is_one(p) ? p.weight : 0.0;
    return weight;
  }

  /// How likely the place is where nobody stands, once particles at both have caught up. Both were as likely before.
  double weight_there(Drawn drawn = {}) {
    Refinement refinement(kParticles);
    refinement.begin(0, drawn.foreseen, true);
    const double odds = static_cast<double>(drawn.there) / (kParticles - drawn.there);
    for (int i = 0; i < kParticles; ++i) {
      const bool there = i < drawn.there;
      Particle p;
      p.weight = 1.0 / kParticles;
      p.room = 0;
      p.position = there ? kThere : kHere;
      p.cov.xx = p.cov.yy = 0.01;
      p.cov.kk = 1e-5;
      if (there && drawn.foreseen > 0) p.foreseen = std::pow(odds, -1.0 / static_cast<double>(drawn.foreseen));
      refinement.population().push(p);
    }
    return weight_of(refinement, [](const Particle& p) { return p.position.y > 1.5; });
  }
};

// A cupboard is heard again and again: what it says for a place must not count as if it were new each time.
TEST_F(RefinementTest, WhatIsHeardOverAndOverLeavesOtherPlacesInMind) {
  for (int pass = 0; pass < 8; ++pass) {
    for (int i = 1; i < belt_.sensors; ++i) hear(kAhead, test::kFarCorner.x - kHere.x);
    if (pass > 1) hear(kLeft, test::kFarCorner.y - kAside);
  }
  const double there = weight_there();
  EXPECT_LT(there, 0.3) << "it does count";
  EXPECT_GT(there, 1e-3);
}

TEST_F(RefinementTest, PlacesThatNothingTellsApartStayAsLikelyAsTheyWere) {
  for (int i = 0; i < 120; ++i) hear(kAhead, test::kFarCorner.x - kHere.x);
  const double there = weight_there();
  EXPECT_NEAR(there, 0.5, 0.1);
}

TEST_F(RefinementTest, WhatParticlesWereDrawnByIsTakenBack) {
  for (int i = 0; i < 120; ++i) hear(kAhead, test::kFarCorner.x - kHere.x);
  EXPECT_NEAR(weight_there({.there = 300, .foreseen = 15}), 0.5, 0.1);
}

// The first firings speak for one place and all together for the other one.
TEST_F(RefinementTest, WhoWasDrawnForWhatComesLaterIsStillThereThen) {
  for (int i = 0; i < 3; ++i) hear(kLeft, test::kFarCorner.y - kAside);
  for (int i = 0; i < 7; ++i) hear(kLeft, kAside);
  EXPECT_GT(weight_there({.there = 395, .foreseen = 10}), 0.5);
}

TEST_F(RefinementTest, StepsTellThoseWhoCatchUpThatTheyWalk) {
  for (int i = 0; i < 40; ++i) {
    Record record = record_of(i % belt_.sensors);
    if (i % 10 == 5) record.gait.standing = 0.1;   // A step.
    history_.push(record);
  }
  Refinement refinement(kParticles);
  refinement.begin(0, 0, true);
  for (int i = 0; i < kParticles; ++i) {
    Particle p;
    p.weight = 1.0 / kParticles;
    p.room = 0;
    p.position = 0.5 * test::kFarCorner;
    p.gait = i % 2 == 0 ? Gait::standing : Gait::walking;
    refinement.population().push(p);
  }
  EXPECT_GT(weight_of(refinement, [](const Particle& p) { return p.gait == Gait::walking; }), 0.9);
}

}  // namespace
}  // namespace echoway::tracker
