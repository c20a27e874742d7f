#include "echoway/building/loader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "echoway/geometry/inclusion.hpp"
#include "support/temp_dir.hpp"

namespace echoway {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path kMaps = ECHOWAY_MAPS_DIR;

constexpr std::string_view kSquare = "4 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n";

Building load(const std::filesystem::path& dir) {
  Result<Building> building = load_building(dir);
  EXPECT_TRUE(building.ok()) << (building.ok() ? "" : building.error().to_string());
  return building.ok() ? std::move(building).value() : Building{};
}

bool has_point(const std::vector<Vec2>& points, double x_ft, double y_ft) {
  return std::any_of(points.begin(), points.end(),
                     [&](Vec2 p) { return distance(p, {feet(x_ft), feet(y_ft)}) < 1e-6; });
}

TEST(LoadBuilding, SampleRoomIsTheThesisTable) {
  const Building building = load(kMaps / "sample-room");
  ASSERT_EQ(building.rooms.size(), 1U);
  const Room& room = building.rooms[0];
  EXPECT_EQ(room.walls.size(), 10U);
  EXPECT_EQ(room.corners.size(), 7U);
  EXPECT_EQ(room.edges.size(), 5U);
  ASSERT_EQ(room.boundary.size(), 1U);
  EXPECT_NEAR(signed_area(room.boundary[0]), (19 * 22 - 4 * 2 - 4 * 1.05) * feet(1) * feet(1), 1e-9);
}

TEST(LoadBuilding, EveryMapIsWithoutFindings) {
  for (const char* map : {"sample-room", "torgersen-lab", "similar-rooms"}) {
    EXPECT_THAT(check_building(kMaps / map), IsEmpty()) << map;
  }
}

TEST(LoadBuilding, DerivesCornersAndEdgesThatAFileLeavesOut) {
  const test::TempDir dir;
  dir.write("room-L.room",
            "6 0 0\n1 0 0 10 0\n1 10 0 10 5\n1 10 5 5 5\n1 5 5 5 10\n1 5 10 0 10\n1 0 10 0 0\n");
  dir.write("building.cfg", "");
  const Room room = load(dir.path()).rooms.at(0);
  EXPECT_EQ(room.corners.size(), 5U);
  ASSERT_EQ(room.edges.size(), 1U);
  EXPECT_TRUE(has_point(room.edges, 5, 5));
}

TEST(LoadBuilding, AStubThatCrossesAWallsEndIsAScreen) {
  const test::TempDir dir;
  dir.write("room-P.room",
            "8 0 0\n1 0 0 0 2\n1 0 2 1 2\n1 1 1.5 1 2.5\n1 1 2.5 2 2.5\n1 2 2.5 2 1\n1 2 1 2.5 1\n1 2.5 1 2.5 0\n"
            "1 2.5 0 0 0\n");
  dir.write("building.cfg", "units m\n");
  const Room room = load(dir.path()).rooms.at(0);
  ASSERT_EQ(room.boundary.size(), 1U);
  EXPECT_TRUE(contains(room.boundary, {0.9, 1.9}));
  EXPECT_TRUE(contains(room.boundary, {1.1, 1.9}));
  EXPECT_FALSE(contains(room.boundary, {0.9, 2.1}));
  EXPECT_EQ(room.corners.size(), 7U);
  EXPECT_EQ(room.edges.size(), 2U);
  EXPECT_EQ(room.walls.size(), 8U);
}

TEST(LoadBuilding, ChainsRoomsThroughTheirDoors) {
  const Building building = load(kMaps / "torgersen-lab");
  ASSERT_EQ(building.rooms.size(), 7U);
  EXPECT_EQ(building.doors.size(), 6U) << "a door listed from either side is one door";
  EXPECT_THAT(building.loop_closures, IsEmpty());
  const Vec2 five = building.room(building.find_room("5")).frame.position;
  EXPECT_NEAR(five.x, feet(-19.5), 1e-9);
  EXPECT_NEAR(five.y, feet(11.5), 1e-9);
}

TEST(LoadBuilding, TakesADoorsWidthFromTheEdgesBesideIt) {
  const Building building = load(kMaps / "torgersen-lab");
  for (const Door& door : building.doors) {
    const bool to_room_5 = building.room(door.room_b).id == "5";
    EXPECT_NEAR(door.width, feet(to_room_5 ? 4.0 : 3.0), 1e-9);
  }
}

TEST(LoadBuilding, RefusesADoorToARoomWithoutAFile) {
  const test::TempDir dir;
  dir.write("room-A.room", kSquare);
  dir.write("building.cfg", "# the door to nowhere\nA 10 5 B 0 5\n");
  const Result<Building> building = load_building(dir.path());
  ASSERT_FALSE(building.ok());
  EXPECT_THAT(building.error().to_string(), HasSubstr("building.cfg:2: "));
  EXPECT_THAT(building.error().message, HasSubstr("room-B.room"));
}

TEST(LoadBuilding, RefusesWallsThatDoNotClose) {
  const test::TempDir dir;
  dir.write("room-A.room", "4 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 1\n");
  dir.write("building.cfg", "");
  const Result<Building> building = load_building(dir.path());
  ASSERT_FALSE(building.ok());
  EXPECT_THAT(building.error().to_string(), HasSubstr("room-A.room:"));
  EXPECT_THAT(building.error().message, HasSubstr("do not close"));
}

}  // namespace
}  // namespace echoway
