#include "tracker/novelty.hpp"

#include <gtest/gtest.h>

#include "echoway/units.hpp"

namespace echoway::tracker {
namespace {

TEST(Novelty, ASensorsFirstReadingIsNewAndItsEchoAtRestHardly) {
  Novelty novelty;
  EXPECT_EQ(novelty.of(3), 1.0);
  EXPECT_EQ(novelty.of(3), Novelty::kLeast);
}

TEST(Novelty, AStepOrATurnMakesItNewAgain) {
  Novelty novelty;
  (void)novelty.of(0);
  novelty.move(0.5, 0.0);
  EXPECT_EQ(novelty.of(0), 1.0);
  novelty.move(0.0, degrees(4.0));
  EXPECT_GT(novelty.of(0), Novelty::kLeast);
  EXPECT_LT(novelty.of(0), 1.0);
}

}  // namespace
}  // namespace echoway::tracker
