#include "tracker/hint_integrator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "echoway/units.hpp"
#include "tracker/motion.hpp"

namespace echoway::tracker {
namespace {

HintIntegrator walked(const std::vector<double>& steps) {
  HintIntegrator hints;
  for (const double t : steps) hints.on_hint({t, MotionKind::step, 1.0});
  if (!steps.empty()) (void)hints.close(steps.back(), 1.0 / 16.0);
  return hints;
}

TEST(HintIntegrator, TellHowFastStepsFollowThoughOneIsMissedAndOneInvented) {
  EXPECT_NEAR(walked({0.0, 0.6, 1.2, 1.8, 2.4, 3.0}).cadence(3.1), 1.0 / 0.6, 1e-9);
  EXPECT_NEAR(walked({0.0, 0.6, 1.8, 2.4, 3.0, 3.6}).cadence(3.7), 1.0 / 0.6, 1e-9) << "the one at 1.2 s was missed";
  EXPECT_NEAR(walked({0.0, 0.6, 1.2, 1.5, 1.8, 2.4, 3.0}).cadence(3.1), 1.0 / 0.6, 1e-9)
      << "the one at 1.5 s was invented";
}

// Feet that turn on the spot step faster than on the way, and go nowhere.
TEST(HintIntegrator, TellThePaceOfTheWayAlsoAfterATurnOnTheSpot) {
  HintIntegrator hints;
  const auto turn_at = [&](double degrees_a_second, double from, double to) {
    for (double t = from; t < to; t += 0.02) hints.on_hint({t, MotionKind::yaw_rate, degrees(degrees_a_second)});
    (void)hints.close(to, 1.0 / 16.0);
  };
  double t = 0.0;
  for (; t < 4.5; t += 1.2) {
    turn_at(0.0, t, t + 1.2);
    hints.on_hint({t + 1.2, MotionKind::step, 1.0});
  }
  for (const double end = t + 3.0; t < end; t += 0.5) {
    turn_at(90.0, t, t + 0.5);
    hints.on_hint({t + 0.5, MotionKind::step, 1.0});
  }
  (void)hints.close(t, 1.0 / 16.0);
  EXPECT_NEAR(hints.cadence(t), 1.0 / 1.2, 1e-6);
  EXPECT_TRUE(hints.in_step(t));
}

TEST(HintIntegrator, TellThePaceAnewAfterStairs) {
  HintIntegrator hints = walked({0.0, 0.6, 1.2, 1.8, 2.4, 3.0});
  hints.forget_cadence();
  EXPECT_EQ(hints.cadence(3.1), 0.0);
  for (const double t : {4.0, 5.2, 6.4}) hints.on_hint({t, MotionKind::step, 1.0});
  (void)hints.close(6.5, 1.0 / 16.0);
  EXPECT_NEAR(hints.cadence(6.5), 1.0 / 1.2, 1e-9);
}

TEST(HintIntegrator, TellNoPaceOfWhoStandsOrHasJustSetOut) {
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

TEST(HintIntegrator, StepsThatAreHeardTellMoreOfThePaceThanEchoesWithoutThem) {
  EXPECT_LT(unsure_of_pace(true), 0.6 * unsure_of_pace(false));
  EXPECT_GT(unsure_of_pace(true), 0.02) << "steps are not all of one length";
}

// One step that a detector invents, or reports late, does not set a wearer walking who stands.
TEST(HintIntegrator, OneStepIsNoWalkAndThreeAreOne) {
  const auto odds_of_standing = [](int steps) {
    HintIntegrator hints;
    double odds = 1.0;
    for (int i = 0; i < steps; ++i) {
      const double t = 0.6 * i;
      hints.on_hint({t, MotionKind::step, 1.0});
      (void)hints.close(t, 1.0 / 16.0);
      const auto evidence = hints.take_gait_evidence(t, 1.0 / 16.0);
      odds *= evidence.standing / evidence.walking;
    }
    return odds;
  };
  EXPECT_GT(odds_of_standing(1), 0.03);
  EXPECT_LT(odds_of_standing(3), 0.001);
}

// Stands for a second, turns by 90 degrees in one, stands again.
double turned_by(double time_s) { return degrees(90.0) * std::clamp(time_s - 1.0, 0.0, 1.0); }

// A gyroscope that reports the mean rate of each `period` seconds of that turn, up to `until`; `reported` counts.
void report_turn(HintIntegrator& hints, double period, double until, int& reported) {
  for (; (reported + 1) * period <= until; ++reported) {
    const double end = (reported + 1) * period;
    hints.on_hint({end, MotionKind::yaw_rate, (turned_by(end) - turned_by(end - period)) / period});
  }
}

// The worst error of the heading over three seconds, degrees, of a gyroscope that reports 25 times a second the mean
// rate of the time since its last report, each reading `late` seconds after its stamp.
double worst_heading_error(double late) {
  HintIntegrator hints;
  double heading = 0.0;
  double worst = 0.0;
  int reported = 0;
  for (double t = 0.0624; t < 3.0; t += 0.0624) {
    report_turn(hints, 0.04, t - late, reported);
    heading += hints.close(t, 0.0624).turn;
    worst = std::max(worst, std::abs(to_degrees(heading - turned_by(t))));
  }
  EXPECT_NEAR(to_degrees(heading), 90.0, 0.1) << "of readings " << late << " s late nothing is lost or counted twice";
  return worst;
}

TEST(HintIntegrator, AHeadingDoesNotLagBehindATurn) {
  // What has been turned since the last reading is guessed from it: at a turn's ends by 40 ms of 90 degrees a second.
  EXPECT_LT(worst_heading_error(0.0), 3.6);
}

TEST(HintIntegrator, ALateReadingMendsWhatWasGuessedInItsPlace) {
  EXPECT_LT(worst_heading_error(0.1), 90.0 * (0.04 + 0.1) + 0.1);
}

// Amid a steady turn nothing is left to guess.
TEST(HintIntegrator, ASteadyTurnIsFollowedExactly) {
  HintIntegrator hints;
  double heading = 0.0;
  double t = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double stamp = 0.02 * i;
    hints.on_hint({stamp, MotionKind::yaw_rate, i > 0 ? degrees(90.0) : 0.0});
    if (stamp - t < 0.0624) continue;
    heading += hints.close(stamp + 0.011, stamp + 0.011 - t).turn;
    t = stamp + 0.011;
    EXPECT_NEAR(to_degrees(heading), 90.0 * t, 1e-9);
  }
}

// A belt listens for 60 ms before it tells of a firing, the phone's sensors tell at once. Live and in a recording,
// where all is in order of time, the wearer faces the same way.
TEST(HintIntegrator, WhatComesBeforeAFiringThoughItIsLaterWaitsForItsTime) {
  const auto headings = [](double early) {
    HintIntegrator hints;
    std::vector<double> turns;
    int reported = 0;
    for (double t = 0.0624; t < 3.0; t += 0.0624) {
      report_turn(hints, 0.02, t + early, reported);
      turns.push_back(hints.close(t, 0.0624).turn);
    }
    return turns;
  };
  EXPECT_EQ(headings(0.06), headings(0.0));
}

TEST(HintIntegrator, OneThatIsStampedFarAheadDoesNotHoldUpTheOthers) {
  HintIntegrator hints;
  hints.on_hint({1e6, MotionKind::yaw_rate, 1.0});
  for (int i = 0; i <= 25; ++i) hints.on_hint({0.04 * i, MotionKind::yaw_rate, degrees(10.0)});
  EXPECT_NEAR(to_degrees(hints.close(1.0, 1.0).turn), 10.0, 1e-9);
}

TEST(HintIntegrator, WhatWaitsWhenTheClockIsSetBackIsNotTakenForTheTimeThatComes) {
  HintIntegrator hints;
  for (int i = 0; i <= 50; ++i) hints.on_hint({9.0 + 0.02 * i, MotionKind::yaw_rate, 0.0});
  (void)hints.close(10.0, 1.0);
  for (int i = 1; i <= 20; ++i) hints.on_hint({10.0 + 0.02 * i, MotionKind::yaw_rate, degrees(90.0)});
  hints.set_clock_back(8.0);
  for (int i = 0; i <= 150; ++i) hints.on_hint({8.0 + 0.02 * i, MotionKind::yaw_rate, degrees(10.0)});
  double turn = 0.0;
  for (double t = 8.0; t <= 11.0; t += 1.0) turn += hints.close(t, 1.0).turn;
  EXPECT_NEAR(to_degrees(turn), 30.0, 0.5);
}

TEST(HintIntegrator, WhileNoBeltIsHeardTurnsAreCountedAllTheSame) {
  HintIntegrator hints;
  for (int i = 0; i <= 1000; ++i) hints.on_hint({0.02 * i, MotionKind::yaw_rate, degrees(5.0)});
  EXPECT_NEAR(to_degrees(hints.close(20.0, 20.0).turn), 100.0, 1e-6);
}

TEST(HintIntegrator, AGyroscopeThatFallsSilentTurnsForHalfASecondMoreAndNoFurther) {
  HintIntegrator hints;
  for (int i = 0; i <= 25; ++i) hints.on_hint({0.04 * i, MotionKind::yaw_rate, degrees(10.0)});
  double heading = hints.close(1.0, 1.0).turn;
  heading += hints.close(3.0, 2.0).turn;
  EXPECT_NEAR(to_degrees(heading), 15.0, 1e-9);
  hints.on_hint({3.0, MotionKind::yaw_rate, 0.0});
  EXPECT_NEAR(to_degrees(hints.close(3.1, 0.1).turn), 0.0, 1e-9) << "what was held stays counted";
}

}  // namespace
}  // namespace echoway::tracker
