#include "tracker/fronts.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

constexpr RoomIndex kRoom = 3;
constexpr std::uint16_t kWall = 7;

TEST(Fronts, AreKnownOnlyBeforeTheWallWhereSomethingAnswered) {
  Fronts fronts;
  EXPECT_FALSE(fronts.before(kRoom, kWall));
  fronts.note(kRoom, kWall, {0.5, 0.75});
  ASSERT_TRUE(fronts.before(kRoom, kWall));
  EXPECT_NEAR(fronts.before(kRoom, kWall)->depth, 0.5, 0.002);
  EXPECT_NEAR(fronts.before(kRoom, kWall)->chance, 0.75, 1.0 / 255.0);
  EXPECT_FALSE(fronts.before(kRoom, kWall + 1));
  EXPECT_FALSE(fronts.before(kRoom + 1, kWall)) << "the same number is another wall there";
  fronts.forget();
  EXPECT_FALSE(fronts.before(kRoom, kWall));
}

TEST(Fronts, AreTheSurerTheMoreOftenTheyAnswered) {
  Fronts fronts;
  fronts.note(kRoom, kWall, {0.5, 0.6});
  fronts.note(kRoom, kWall, {0.5, 0.6});
  const double twice = fronts.before(kRoom, kWall)->chance;
  EXPECT_GT(twice, 0.6);
  for (int i = 0; i < 100; ++i) fronts.note(kRoom, kWall, {0.5, 0.6});
  EXPECT_GT(fronts.before(kRoom, kWall)->chance, twice);
  EXPECT_LE(fronts.before(kRoom, kWall)->chance, 1.0);
}

TEST(Fronts, FollowWhereTheyAnswerFrom) {
  Fronts fronts;
  fronts.note(kRoom, kWall, {0.4, 1.0});
  for (int i = 0; i < 20; ++i) fronts.note(kRoom, kWall, {0.6, 1.0});
  EXPECT_NEAR(fronts.before(kRoom, kWall)->depth, 0.6, 0.01);
}

TEST(Fronts, ForgetTheWallNotedFirstWhenThereAreTooMany) {
  Fronts fronts;
  for (std::uint16_t wall = 0; wall <= Fronts::kSlots; ++wall) fronts.note(kRoom, wall, {0.5, 1.0});
  EXPECT_FALSE(fronts.before(kRoom, 0));
  for (std::uint16_t wall = 1; wall <= Fronts::kSlots; ++wall) EXPECT_TRUE(fronts.before(kRoom, wall)) << wall;
}

}  // namespace
}  // namespace echoway::tracker
