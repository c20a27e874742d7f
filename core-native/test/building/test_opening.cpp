#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "echoway/building/opening.hpp"
#include "support/rooms.hpp"

namespace echoway {
namespace {

using testing::SizeIs;

TEST(FindOpening, LiesOnTheNearestWall) {
  const Room room = rooms::rectangle(10.0, 8.0);
  const auto opening = find_opening(room, {10.1, 3.0}, 0.9);
  ASSERT_TRUE(opening.has_value());
  EXPECT_EQ(opening->wall, 1U);
  EXPECT_NEAR(opening->span.length(), 0.9, 1e-12);
  EXPECT_NEAR(opening->span.a.y, 2.55, 1e-12);
  EXPECT_NEAR(opening->span.b.y, 3.45, 1e-12);
  EXPECT_NEAR(opening->span.a.x, 10.0, 1e-12);
}

TEST(FindOpening, StaysOnItsWall) {
  const auto opening = find_opening(rooms::rectangle(10.0, 8.0), {10.0, 0.2}, 1.0);
  ASSERT_TRUE(opening.has_value());
  EXPECT_NEAR(opening->span.length(), 0.7, 1e-12);
}

TEST(FindOpening, IsNowhereWithoutAWallOrAWidth) {
  const Room room = rooms::rectangle(10.0, 8.0);
  EXPECT_FALSE(find_opening(room, {5.0, 4.0}, 0.9).has_value());
  EXPECT_FALSE(find_opening(room, {10.0, 4.0}, 0.0).has_value());
  EXPECT_FALSE(find_opening(Room{}, {0.0, 0.0}, 0.9).has_value());
}

TEST(FindOpenings, SeesADoorFromBothRooms) {
  Building building;
  building.rooms = {rooms::rectangle(10.0, 8.0), rooms::rectangle(4.0, 4.0)};
  building.doors = {{0, {10.0, 3.0}, 1, {0.0, 2.0}, 0.9}};
  const auto openings = find_openings(building);
  ASSERT_THAT(openings, SizeIs(2));
  ASSERT_THAT(openings[0], SizeIs(1));
  ASSERT_THAT(openings[1], SizeIs(1));
  EXPECT_EQ(openings[0][0].beyond, 1);
  EXPECT_EQ(openings[1][0].beyond, 0);
  EXPECT_EQ(openings[1][0].wall, 3U);
}

TEST(WallsWithDoorsOpen, LeavesThePiecesBesideTheDoor) {
  Building building;
  building.rooms = {rooms::rectangle(10.0, 8.0), rooms::rectangle(4.0, 4.0)};
  building.doors = {{0, {10.0, 3.0}, 1, {0.0, 2.0}, 1.0}};
  building.rooms[0].walls.push_back({{10.0, 2.0}, {10.0, 3.2}});  // drawn twice for a stretch
  const std::vector<Segment> pieces = walls_with_doors_open(building.rooms[0], find_openings(building)[0]);
  ASSERT_THAT(pieces, SizeIs(6));
  EXPECT_EQ(pieces[1], (Segment{{10.0, 0.0}, {10.0, 2.5}}));
  EXPECT_EQ(pieces[2], (Segment{{10.0, 3.5}, {10.0, 8.0}}));
  EXPECT_EQ(pieces[5], (Segment{{10.0, 2.0}, {10.0, 2.5}}));
}

}  // namespace
}  // namespace echoway
