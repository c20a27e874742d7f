#include "echoway/geometry/pose2.hpp"

#include <gtest/gtest.h>

namespace echoway {
namespace {

TEST(Pose2, TransformThenInverseGivesThePointBack) {
  const Pose2 frame{{3.0, -2.0}, degrees(30.0)};
  const Vec2 back = frame.inverse_transform(frame.transform({1.25, 7.5}));
  EXPECT_NEAR(back.x, 1.25, 1e-12);
  EXPECT_NEAR(back.y, 7.5, 1e-12);
}

TEST(Pose2, ComposeTurnsCounterClockwise) {
  const Pose2 east_facing_north{{1.0, 0.0}, degrees(90.0)};
  const Pose2 result = east_facing_north.compose({{2.0, 0.0}, degrees(90.0)});
  EXPECT_NEAR(result.position.x, 1.0, 1e-12);
  EXPECT_NEAR(result.position.y, 2.0, 1e-12);
  EXPECT_NEAR(result.heading, kPi, 1e-12);
}

TEST(WrapAngle, KeepsTheHalfOpenInterval) {
  EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi);
  EXPECT_NEAR(wrap_angle(degrees(370.0)), degrees(10.0), 1e-12);
  EXPECT_NEAR(wrap_angle(degrees(-190.0)), degrees(170.0), 1e-12);
}

}  // namespace
}  // namespace echoway
