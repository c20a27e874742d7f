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

}  // namespace
}  // namespace echoway
