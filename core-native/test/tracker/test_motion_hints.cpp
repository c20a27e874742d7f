#include "tracker/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace echoway::tracker {
namespace {

HintIntegrator walked(const std::vector<double>& steps) {
  HintIntegrator hints;
  for (const double t : steps) hints.on_hint({t, MotionKind::step, 1.0});
  return hints;
}

TEST(MotionHints, TellHowFastStepsFollowThoughOneIsMissedAndOneInvented) {
  EXPECT_NEAR(walked({0.0, 0.6, 1.2, 1.8, 2.4, 3.0}).cadence(3.1), 1.0 / 0.6, 1e-9);
  EXPECT_NEAR(walked({0.0, 0.6, 1.8, 2.4, 3.0, 3.6}).cadence(3.7), 1.0 / 0.6, 1e-9) << "the one at 1.2 s was missed";
  EXPECT_NEAR(walked({0.0, 0.6, 1.2, 1.5, 1.8, 2.4, 3.0}).cadence(3.1), 1.0 / 0.6, 1e-9) << "the one at 1.5 s was invented";
}

TEST(MotionHints, TellNoPaceOfWhoStandsOrHasJustSetOut) {
  EXPECT_EQ(walked({}).cadence(1.0), 0.0);
  EXPECT_EQ(walked({0.0, 0.6}).cadence(0.7), 0.0);
  EXPECT_EQ(walked({0.0, 0.6, 1.2, 1.8}).cadence(9.0), 0.0);
}

// How well the pace of a walker is known, m/s, when no echo has told anything for ten seconds.
double unsure_of_pace(bool in_step) {
  const MotionParameters parameters;
  Interval firing;
  firing.seconds = 1.0 / 16.0;
  firing.turn_known = true;
  firing.in_step = in_step;
  Particle p;
  double squares = 0.0;
  int walking = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    p = {};
    p.gait = Gait::walking;
    p.speed = 0.5;
    for (int i = 0; i < 160 && p.gait == Gait::walking; ++i) Stride(firing, parameters, 0.5).advance(p, random);
    if (p.gait != Gait::walking) continue;
    squares += p.cov.ss;
    ++walking;
  }
  return std::sqrt(squares / walking);
}

TEST(MotionHints, StepsThatAreHeardTellMoreOfThePaceThanEchoesWithoutThem) {
  EXPECT_LT(unsure_of_pace(true), 0.6 * unsure_of_pace(false));
  EXPECT_GT(unsure_of_pace(true), 0.02) << "steps are not all of one length";
}

// One step that a detector invents, or reports late, does not set a wearer walking who stands.
TEST(MotionHints, OneStepIsNoWalkAndThreeAreOne) {
  const auto odds_of_standing = [](int steps) {
    HintIntegrator hints;
    double odds = 1.0;
    for (int i = 0; i < steps; ++i) {
      const double t = 0.6 * i;
      hints.on_hint({t, MotionKind::step, 1.0});
      const auto evidence = hints.take_gait_evidence(t, 1.0 / 16.0);
      odds *= evidence.standing / evidence.walking;
    }
    return odds;
  };
  EXPECT_GT(odds_of_standing(1), 0.03);
  EXPECT_LT(odds_of_standing(3), 0.001);
}

}  // namespace
}  // namespace echoway::tracker
