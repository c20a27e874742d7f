#include "tracker/echo_pairs.hpp"

#include <gtest/gtest.h>

#include "echoway/units.hpp"

namespace echoway::tracker {
namespace {

constexpr double kPass = 15 * 0.0624;   // Seconds.

class EchoPairsTest : public ::testing::Test {
 protected:
  EchoPairsTest() { EXPECT_FALSE(pairs_.hear(3, 2.0, 1.0)) << "a first echo has none before it"; }

  EchoPairs pairs_;
};

TEST_F(EchoPairsTest, AreAnEchoAndTheLastOneOfItsSensor) {
  const auto pair = pairs_.hear(3, 1.6, 1.0 + kPass);
  ASSERT_TRUE(pair);
  EXPECT_DOUBLE_EQ(pair->seconds, kPass);
  EXPECT_EQ(pair->before, 2.0);
  EXPECT_EQ(pair->range, 1.6);
  EXPECT_FALSE(pairs_.hear(4, 1.6, 1.0 + kPass)) << "another sensor's";
}

TEST_F(EchoPairsTest, DoNotOutlastATurn) {
  pairs_.turn(degrees(8.0));
  EXPECT_FALSE(pairs_.hear(3, 2.0, 1.0 + kPass)) << "the sensor looks elsewhere now";
  pairs_.turn(degrees(-4.0));
  EXPECT_TRUE(pairs_.hear(3, 2.0, 1.0 + 2.0 * kPass)) << "who walks straight sways a little";
}

TEST_F(EchoPairsTest, DoNotReachFarBack) { EXPECT_FALSE(pairs_.hear(3, 2.0, 2.6)); }

TEST_F(EchoPairsTest, DoNotReachBackFromAClockThatWasSetBack) { EXPECT_FALSE(pairs_.hear(3, 2.0, 0.5)); }

}  // namespace
}  // namespace echoway::tracker
