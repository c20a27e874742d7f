#include "tracker/strangers.hpp"

#include <gtest/gtest.h>

#include "tracker/motion.hpp"
#include "tracker/particle.hpp"

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

TEST(Strangers, KeepTheirPlaceForWhoWalksPastThem) {
  Strangers strangers;
  strangers.move({0.0, -10.0});
  strangers.note(2, {3.0, -9.0}, 1.0);
  for (int step = 0; step < 20; ++step) strangers.move({0.0, -0.9});
  EXPECT_NEAR(strangers.from_here(2).x, 3.0, 3.0 * kMillimetre);
  EXPECT_NEAR(strangers.from_here(2).y, 9.0, 3.0 * kMillimetre);
}

class WayOfAStranger : public ::testing::TestWithParam<Gait> {};

TEST_P(WayOfAStranger, IsThatOfWhoWalksOrClimbs) {
  Particle p;
  p.gait = GetParam();
  p.speed = 0.4;
  p.strangers.note(0, {3.0, 1.0}, 1.0);
  const MotionParameters motion;
  Interval half_a_second;
  half_a_second.seconds = 0.5;
  half_a_second.turn_known = true;
  Random random(2);
  Stride(half_a_second, motion, 0.4).advance(p, random);
  constexpr double kAskew = 0.02;   // Metres: nobody turns here but by the gyroscope's noise.
  EXPECT_NEAR(p.strangers.from_here(0).x, 2.8, kAskew);
  EXPECT_NEAR(p.strangers.from_here(0).y, 1.0, kAskew);
}

INSTANTIATE_TEST_SUITE_P(Gaits, WayOfAStranger, ::testing::Values(Gait::walking, Gait::away));

TEST(Strangers, TurnWithTheParticleThatEntersARoomDrawnOtherwise) {
  Particle p;
  p.strangers.note(0, {2.0, 0.0}, 1.0);
  turn(p, {0.0, 1.0});
  EXPECT_NEAR(p.strangers.from_here(0).x, 0.0, kMillimetre);
  EXPECT_NEAR(p.strangers.from_here(0).y, 2.0, kMillimetre) << "still straight ahead";
}

}  // namespace
}  // namespace echoway::tracker
