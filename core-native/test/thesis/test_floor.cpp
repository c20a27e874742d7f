#include "thesis/floor.hpp"

#include <gtest/gtest.h>

#include "support/rooms.hpp"

namespace echoway::thesis {
namespace {

TEST(Floor, CountsCrossingsAsInFigure5Point5) {
  const Floor floor(rooms::with_pier());
  EXPECT_TRUE(floor.contains({1.0, 1.0}));
  EXPECT_TRUE(floor.contains({5.0, 1.0}));
  EXPECT_FALSE(floor.contains({2.5, 1.0}));  // in the pier
  EXPECT_FALSE(floor.contains({-1.0, 1.0}));
  EXPECT_FALSE(floor.contains({7.0, 1.0}));
}

TEST(Floor, CountsALineThroughAVertexOnce) {
  // The line y = 1.5 runs along the pier's top and through two vertices.
  const Floor floor(rooms::with_pier());
  EXPECT_TRUE(floor.contains({1.0, 1.5}));
  EXPECT_TRUE(floor.contains({5.0, 1.5}));
}

TEST(Floor, TakesTheWallsOfARoomWithoutBoundary) {
  Room room = rooms::with_pier();
  room.boundary.clear();
  const Floor floor(room);
  EXPECT_TRUE(floor.contains({1.0, 1.0}));
  EXPECT_FALSE(floor.contains({2.5, 1.0}));
}

TEST(Floor, IgnoresScreensWhenThereIsABoundary) {
  Room room = rooms::rectangle(6.0, 4.0);
  room.walls.push_back({{3.0, 1.0}, {3.0, 3.0}});
  EXPECT_TRUE(Floor(room).contains({1.0, 2.0}));
}

TEST(Floor, OfNothingContainsNothing) { EXPECT_FALSE(Floor(Room{}).contains({0.0, 0.0})); }

}  // namespace
}  // namespace echoway::thesis
