#include "tracker/strangers.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

constexpr double kMillimetre = 1e-3;

TEST(Strangers, StayWhereTheyStandWhileTheWearerWalks) {
  Strangers strangers;
  strangers.note(2, {3.0, 1.0}, 1.0);
  strangers.move({0.5, -0.25});
  EXPECT_NEAR(strangers.from_here(2).x, 2.5, kMillimetre);
  EXPECT_NEAR(strangers.from_here(2).y, 1.25, kMillimetre);
}

TEST(Strangers, AreSeenInTheFrameOfTheRoomThatIsEntered) {
  Strangers strangers;
  strangers.move({4.0, 2.0});
  strangers.note(0, {3.0, 1.0}, 1.0);
  strangers.turn({0.0, 1.0});   // A quarter to the left.
  EXPECT_NEAR(strangers.from_here(0).x, -1.0, kMillimetre);
  EXPECT_NEAR(strangers.from_here(0).y, 3.0, kMillimetre);
  strangers.move({-1.0, 0.0});
  EXPECT_NEAR(strangers.from_here(0).x, 0.0, kMillimetre) << "it is walked up to in the new frame as well";
}

TEST(Strangers, AreAsSureAsTheyWereToldToBe) {
  Strangers strangers;
  EXPECT_EQ(strangers.chance(5), 0.0) << "nothing has answered yet";
  strangers.note(5, {1.0, 0.0}, 0.5);
  EXPECT_NEAR(strangers.chance(5), 0.5, 1.0 / 255.0);
  strangers.note(5, {1.0, 0.0}, 1.0 + 1e-9);
  EXPECT_EQ(strangers.chance(5), 1.0);
  strangers.forget();
  EXPECT_EQ(strangers.chance(5), 0.0);
}

TEST(Strangers, KeepTheirPlaceToAMillimetreAfterAWalkOfAKilometre) {
  Strangers strangers;
  strangers.move({1000.0, -1000.0});
  strangers.note(1, {2.0, 1.0}, 1.0);
  EXPECT_NEAR(strangers.from_here(1).x, 2.0, kMillimetre);
  EXPECT_NEAR(strangers.from_here(1).y, 1.0, kMillimetre);
}

}  // namespace
}  // namespace echoway::tracker
