#include "tracker/echo_repeats.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

TEST(EchoRepeats, ExpectAnArmAtTheSameDistanceOfTheSameSensor) {
  EchoRepeats repeats;
  repeats.note(4, 0.25, 0.0);
  ASSERT_EQ(repeats.match(4, 0.25, 0.94).size(), 1u);
  EXPECT_GT(repeats.match(4, 0.25, 0.94)[0].alike, 2.5);
  EXPECT_LT(repeats.match(4, 0.75, 0.94)[0].alike, 0.1) << "half a metre farther off it is something else";
  EXPECT_EQ(repeats.match(9, 0.25, 0.94)[0].alike, 0.0) << "another sensor looks elsewhere";
}

TEST(EchoRepeats, AreLessSureOfWhereAThingStandsTheLongerAgoItAnswered) {
  EchoRepeats repeats;
  repeats.note(0, 3.0, 0.0);
  const double soon = repeats.match(0, 3.0, 0.5)[0].sigma;
  EXPECT_GT(repeats.match(0, 3.0, 2.0)[0].sigma, 1.3 * soon);
}

TEST(EchoRepeats, ForgetWhatWasHeardLongAgo) {
  EchoRepeats repeats;
  repeats.note(0, 3.0, 0.0);
  EXPECT_EQ(repeats.match(0, 3.0, 2.0).size(), 1u);
  EXPECT_TRUE(repeats.match(0, 3.0, 3.0).empty());
}

TEST(EchoRepeats, ExpectNothingOfEchoesAfterNowWhenTheClockWasSetBack) {
  EchoRepeats repeats;
  repeats.note(0, 3.0, 5.0);
  EXPECT_TRUE(repeats.match(0, 3.0, 4.5).empty());
}

TEST(EchoRepeats, OfABeltOfManySensorsKeepTheNewestOfThoseThatShareASlot) {
  EchoRepeats repeats;
  constexpr int kOther = 3 + static_cast<int>(Strangers::kSlots);
  repeats.note(3, 1.0, 0.0);
  repeats.note(kOther, 2.0, 0.5);
  ASSERT_EQ(repeats.match(kOther, 2.0, 1.0).size(), 1u);
  EXPECT_GT(repeats.match(kOther, 2.0, 1.0)[0].alike, 2.5);
  EXPECT_EQ(repeats.match(3, 1.0, 1.0)[0].alike, 0.0);
}

}  // namespace
}  // namespace echoway::tracker
