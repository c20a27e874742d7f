#include "tracker/association.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace echoway::tracker {
namespace {

constexpr Vec2 kTowardsTheWall{-1.0, 0.0};   // Gradient of the range of a wall ahead.

Particle blurred_by(double sigma) {
  Particle p;
  p.cov.xx = p.cov.yy = sigma * sigma;
  return p;
}

// A wall ahead that was heard `nearer` than expected, if it is what answered.
Association wall(const Particle& p, double share, double nearer) {
  const double noise = 0.02;
  return {share, -nearer, p.cov.xx + noise * noise, covariation(p.cov, kTowardsTheWall, 0.0)};
}

TEST(Association, TakesOneSideWhereAWallAndACupboardWouldPutTheWearerApart) {
  constexpr int kDraws = 2000;
  constexpr double kShare = 0.6, kNearer = 0.5;
  Random random(1);
  int at_the_wall = 0;
  for (int i = 0; i < kDraws; ++i) {
    Particle p = blurred_by(0.3);
    const std::array<Association, 1> heard{wall(p, kShare, kNearer)};
    merge_or_choose(p, heard, random);
    if (p.position.x > 0.25) {
      EXPECT_NEAR(p.position.x, kNearer, 0.01);
      EXPECT_LT(p.cov.xx, 0.03 * 0.03) << "and it is known how far that is";
      ++at_the_wall;
    } else {
      EXPECT_EQ(p.position.x, 0.0);
      EXPECT_EQ(p.cov.xx, 0.3 * 0.3) << "a cupboard of which the plan knows nothing tells nothing";
    }
  }
  EXPECT_NEAR(at_the_wall, kShare * kDraws, 3.0 * std::sqrt(kShare * (1.0 - kShare) * kDraws));
}

TEST(Association, AveragesWhatHardlyMatters) {
  Random random(1);
  Particle p = blurred_by(0.05);
  const std::array<Association, 1> heard{wall(p, 0.6, 0.05)};
  merge_or_choose(p, heard, random);
  EXPECT_NEAR(p.position.x, 0.6 * 0.05 * 25.0 / 29.0, 1e-12);
  EXPECT_EQ(random.next(), Random(1).next()) << "nothing was drawn";
}

TEST(Association, OfTwoWallsTakesTheOneThatIsDrawn) {
  Random random(2);
  std::array<int, 2> taken{};
  for (int i = 0; i < 1000; ++i) {
    Particle p = blurred_by(0.3);
    const std::array<Association, 2> heard{wall(p, 0.25, 0.4), wall(p, 0.75, -0.6)};
    merge_or_choose(p, heard, random);
    ASSERT_TRUE(std::abs(p.position.x - 0.4) < 0.01 || std::abs(p.position.x + 0.6) < 0.01) << p.position.x;
    ++taken[p.position.x > 0.0 ? 0 : 1];
  }
  EXPECT_NEAR(taken[0], 250, 45);
}

TEST(Association, LeavesAPlaceAloneThatNothingInThePlanAnswered) {
  Random random(1);
  Particle p = blurred_by(0.3);
  const std::array<Association, 1> heard{wall(p, 1e-4, 0.5)};
  merge_or_choose(p, heard, random);
  EXPECT_EQ(p.position.x, 0.0);
  EXPECT_EQ(p.cov.xx, 0.3 * 0.3);
}

}  // namespace
}  // namespace echoway::tracker
