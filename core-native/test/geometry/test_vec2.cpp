#include "echoway/geometry/vec2.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace echoway {
namespace {

TEST(Hypotenuse, IsRightFromTheSmallestToTheLargest) {
  for (const double scale : {1e-300, 1e-150, 1e-9, 1.0, 1e6, 1e150, 1e300}) {
    EXPECT_DOUBLE_EQ(hypotenuse(3.0 * scale, -4.0 * scale), 5.0 * scale) << scale;
  }
  EXPECT_EQ(hypotenuse(0.0, 0.0), 0.0);
  EXPECT_EQ(hypotenuse(-2.0, 0.0), 2.0);
}

TEST(Hypotenuse, IsInfiniteOnlyForWhatIs) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(hypotenuse(kInfinity, 1.0), kInfinity);
  EXPECT_TRUE(std::isnan(hypotenuse(std::numeric_limits<double>::quiet_NaN(), 1.0)));
}

TEST(Rotated, TurnsCounterClockwiseByTheUnitsAngle) {
  const Vec2 quarter{0.0, 1.0};
  EXPECT_EQ(rotated({2.0, 1.0}, quarter), perpendicular({2.0, 1.0}));
  EXPECT_EQ(rotated({1.0, 0.0}, unit_from_angle(0.3)), unit_from_angle(0.3));
  const Vec2 twice = rotated(unit_from_angle(0.3), unit_from_angle(0.4));
  EXPECT_NEAR(distance(twice, unit_from_angle(0.7)), 0.0, 1e-15);
}

}  // namespace
}  // namespace echoway
