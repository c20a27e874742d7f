#include "tracker/motion.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace echoway::tracker
