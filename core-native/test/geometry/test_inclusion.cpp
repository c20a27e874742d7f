#include <gtest/gtest.h>

#include <limits>

#include "echoway/geometry/inclusion.hpp"
#include "echoway/random.hpp"

namespace echoway {
namespace {

using Loops = std::vector<std::vector<Vec2>>;

/// 10 x 10 with a square column from 4 to 6.
const Loops kWithColumn{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}};

TEST(Classify, TellsFloorFromColumnAndOutside) {
  EXPECT_EQ(classify(kWithColumn, {1, 1}), Inclusion::inside);
  EXPECT_EQ(classify(kWithColumn, {5, 5}), Inclusion::outside);
  EXPECT_EQ(classify(kWithColumn, {11, 5}), Inclusion::outside);
  EXPECT_EQ(classify(kWithColumn, {-1, 5}), Inclusion::outside);
}

TEST(Classify, PointsOnWallsAndVerticesAreOnTheBoundary) {
  for (const Vec2 p : {Vec2{0, 0}, Vec2{10, 10}, Vec2{5, 0}, Vec2{0, 3}, Vec2{4, 5}, Vec2{6, 6}}) {
    EXPECT_EQ(classify(kWithColumn, p), Inclusion::on_boundary);
    EXPECT_TRUE(contains(kWithColumn, p));
  }
}

TEST(Classify, ARayThroughVerticesCountsThemOnce) {
  // At the heights of vertices: the ray towards +x meets the column's corners, or runs along its edge.
  EXPECT_EQ(classify(kWithColumn, {1, 4}), Inclusion::inside);
  EXPECT_EQ(classify(kWithColumn, {1, 6}), Inclusion::inside);
  EXPECT_EQ(classify(kWithColumn, {-1, 0}), Inclusion::outside);
  EXPECT_EQ(classify(kWithColumn, {-1, 10}), Inclusion::outside);
  const Loops diamond{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  EXPECT_EQ(classify(diamond, {0, 0}), Inclusion::inside);
  EXPECT_EQ(classify(diamond, {-2, 0}), Inclusion::outside);
}

TEST(Classify, HoldsFarFromTheOriginAndForSlivers) {
  for (const Vec2 offset : {Vec2{1e6, -1e6}, Vec2{-1e6, 3e5}}) {
    Loops moved = kWithColumn;
    for (auto& loop : moved) {
      for (Vec2& p : loop) p = p + offset;
    }
    EXPECT_EQ(classify(moved, offset + Vec2{1, 1}), Inclusion::inside);
    EXPECT_EQ(classify(moved, offset + Vec2{5, 5}), Inclusion::outside);
    EXPECT_EQ(classify(moved, offset + Vec2{5, 0}), Inclusion::on_boundary);
  }
  const Loops sliver{{{0, 0}, {200, 0}, {200, 0.1}, {0, 0.1}}};
  EXPECT_EQ(classify(sliver, {199.9, 0.05}), Inclusion::inside);
  EXPECT_EQ(classify(sliver, {100, 0.11}), Inclusion::outside);
}

TEST(Classify, ReflexRoomsOfManyWallsAgreeWithTheirRadius) {
  // A star of 500 walls: inside where nearer to the centre than the outline in that direction.
  std::vector<Vec2> star;
  constexpr int kPoints = 500;
  for (int i = 0; i < kPoints; ++i) star.push_back((i % 2 == 0 ? 10.0 : 4.0) * unit_from_angle(kTwoPi * i / kPoints));
  const Loops loops{star};
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 direction = unit_from_angle(random.uniform(0.0, kTwoPi));
    EXPECT_EQ(classify(loops, random.uniform(0.0, 3.99) * direction), Inclusion::inside);
    EXPECT_EQ(classify(loops, random.uniform(10.01, 30.0) * direction), Inclusion::outside);
  }
}

TEST(Classify, NothingIsInsideWithoutLoopsOrNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(classify({}, {0, 0}), Inclusion::outside);
  EXPECT_EQ(classify(Loops{{}}, {0, 0}), Inclusion::outside);
  EXPECT_EQ(classify(kWithColumn, {nan, 5}), Inclusion::outside);
  EXPECT_EQ(classify(kWithColumn, {5, std::numeric_limits<double>::infinity()}), Inclusion::outside);
}

TEST(SignedArea, IsPositiveCounterClockwise) {
  EXPECT_DOUBLE_EQ(signed_area(kWithColumn[0]), 100.0);
  EXPECT_DOUBLE_EQ(signed_area(kWithColumn[1]), -4.0);
  const std::vector<Vec2> far{{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6 + 1, 1e6 + 1}, {1e6, 1e6 + 1}};
  EXPECT_DOUBLE_EQ(signed_area(far), 1.0);
}

}  // namespace
}  // namespace echoway
