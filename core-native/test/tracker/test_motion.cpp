#include "tracker/motion.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

constexpr int kMany = 20000;

struct SetOut {
  double particles = 0.0;   // Share of them.
  double weight = 0.0;      // Share of it.
};

// Of those who stand, how many walk a firing later.
SetOut set_out(const HintIntegrator::GaitEvidence& steps) {
  const MotionParameters parameters;
  Interval firing;
  firing.seconds = 0.0624;
  firing.turn_known = true;
  const Stride stride(firing, parameters, 0.5, steps);
  Random random(3);
  double walking = 0.0, walking_weight = 0.0, weight = 0.0;
  for (int i = 0; i < kMany; ++i) {
    Particle p;
    p.weight = 1.0;
    stride.advance(p, random);
    weight += p.weight;
    if (p.gait != Gait::walking) continue;
    walking += 1.0;
    walking_weight += p.weight;
  }
  return {walking / kMany, walking_weight / weight};
}

TEST(Motion, AStepSetsManyOfTheParticlesThatStandWalking) {
  EXPECT_GT(set_out({.standing = 0.05, .walking = 1.0}).particles, 0.2);
  EXPECT_LT(set_out({}).particles, 0.05) << "who stands mostly stands on";
}

TEST(Motion, AStepTellsOfSettingOutWhatItsLikelihoodsSay) {
  constexpr double kOdds = 20.0;
  const double before = set_out({}).weight;
  const double after = set_out({.standing = 1.0 / kOdds, .walking = 1.0}).weight;
  const double expected = kOdds * before / (1.0 - before);
  EXPECT_NEAR(after / (1.0 - after), expected, 0.15 * expected);
}

TEST(Motion, StepsWeighParticlesThoughNoTimeHasPassed) {
  const MotionParameters parameters;
  Random random(1);
  Particle p;
  p.weight = 1.0;
  Stride({}, parameters, 0.5, {.standing = 0.25, .walking = 1.0}).advance(p, random);
  EXPECT_DOUBLE_EQ(p.weight, 0.25);
}

}  // namespace
}  // namespace echoway::tracker
