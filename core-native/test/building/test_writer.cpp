#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"
#include "support/process.hpp"
#include "support/rooms.hpp"

namespace echoway {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kTenthOfAMillimetre = 1e-4;

void expect_same(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(distance(a[i], b[i]), 0.0, kTenthOfAMillimetre);
}

void expect_same(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(distance(a[i].a, b[i].a), 0.0, kTenthOfAMillimetre);
    EXPECT_NEAR(distance(a[i].b, b[i].b), 0.0, kTenthOfAMillimetre);
  }
}

void expect_same(const std::vector<Landmark>& a, const std::vector<Landmark>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].room, b[i].room);
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_NEAR(distance(a[i].at, b[i].at), 0.0, kTenthOfAMillimetre);
  }
}

void expect_same(const Building& a, const Building& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.unit, b.unit);
  ASSERT_EQ(a.rooms.size(), b.rooms.size());
  for (std::size_t i = 0; i < a.rooms.size(); ++i) {
    SCOPED_TRACE("room " + a.rooms[i].id);
    EXPECT_EQ(a.rooms[i].id, b.rooms[i].id);
    EXPECT_EQ(a.rooms[i].name, b.rooms[i].name);
    EXPECT_EQ(a.rooms[i].level, b.rooms[i].level);
    EXPECT_NEAR(distance(a.rooms[i].frame.position, b.rooms[i].frame.position), 0.0, kTenthOfAMillimetre);
    EXPECT_NEAR(a.rooms[i].frame.heading, b.rooms[i].frame.heading, 1e-7);
    expect_same(a.rooms[i].walls, b.rooms[i].walls);
    expect_same(a.rooms[i].reflectors, b.rooms[i].reflectors);
    expect_same(a.rooms[i].corners, b.rooms[i].corners);
    expect_same(a.rooms[i].edges, b.rooms[i].edges);
    ASSERT_EQ(a.rooms[i].boundary.size(), b.rooms[i].boundary.size());
    for (std::size_t k = 0; k < a.rooms[i].boundary.size(); ++k) {
      expect_same(a.rooms[i].boundary[k], b.rooms[i].boundary[k]);
    }
  }
  ASSERT_EQ(a.doors.size(), b.doors.size());
  for (std::size_t i = 0; i < a.doors.size(); ++i) {
    EXPECT_EQ(a.doors[i].room_a, b.doors[i].room_a);
    EXPECT_EQ(a.doors[i].room_b, b.doors[i].room_b);
    EXPECT_NEAR(distance(a.doors[i].at_a, b.doors[i].at_a), 0.0, kTenthOfAMillimetre);
    EXPECT_NEAR(distance(a.doors[i].at_b, b.doors[i].at_b), 0.0, kTenthOfAMillimetre);
    EXPECT_NEAR(a.doors[i].width, b.doors[i].width, kTenthOfAMillimetre);
  }
  ASSERT_EQ(a.links.size(), b.links.size());
  for (std::size_t i = 0; i < a.links.size(); ++i) {
    EXPECT_EQ(a.links[i].kind, b.links[i].kind);
    EXPECT_EQ(a.links[i].room_a, b.links[i].room_a);
    EXPECT_EQ(a.links[i].room_b, b.links[i].room_b);
  }
  expect_same(a.exits, b.exits);
  expect_same(a.places, b.places);
  ASSERT_EQ(a.loop_closures.size(), b.loop_closures.size());
  for (std::size_t i = 0; i < a.loop_closures.size(); ++i) {
    EXPECT_EQ(a.loop_closures[i].door, b.loop_closures[i].door);
    EXPECT_NEAR(a.loop_closures[i].error, b.loop_closures[i].error, 3 * kTenthOfAMillimetre);
  }
}

Building round_trip(const Building& building) {
  const test::TemporaryFolder dir;
  const Status written = write_building(building, dir.path() / "new" / "folder");
  EXPECT_TRUE(written.ok()) << written.error().to_string();
  Result<Building> back = load_building(dir.path() / "new" / "folder");
  EXPECT_TRUE(back.ok()) << back.error().to_string();
  return back.ok() ? std::move(back).value() : Building{};
}

TEST(WriteBuilding, TheMapsComeBackTheSame) {
  for (const auto& map : std::filesystem::directory_iterator(ECHOWAY_MAPS_DIR)) {
    if (!map.is_directory()) continue;
    SCOPED_TRACE(map.path().string());
    Result<Building> building = load_building(map.path());
    ASSERT_TRUE(building.ok());
    expect_same(*building, round_trip(*building));
  }
}

/// Everything that a building can have.
Building everything() {
  const test::TemporaryFolder dir;
  constexpr std::string_view box = "4 0 0\n1 0 0 10 0\n1 10 0 10 8\n1 10 8 0 8\n1 0 8 0 0\n";
  dir.write("room-1.room", box);
  dir.write("room-2.room",
            "5 0 0 2\n1 0 0 10 0\n1 10 0 10 8\n1 10 8 0 8\n1 0 8 0 0\n1 4 0 4.5 3\n4 7 7 8 7\n4 8 7 8 6\n");
  dir.write("room-10.room", box);
  dir.write("room-up.room", "3 0 0\n1 0 0 20 0\n1 20 0 10 15\n1 10 15 0 0\n");
  dir.write(
      "building.cfg",
      "units m\nname \"The \\\"old\\\" mill # 3\"\nroom up level -2 \"Dachgescho\xC3\x9F\"\nroom 1 level 0 \"Entry\"\n"
      "frame 2 30.5 -4 33.3\n1 10 4 2 0 4\ndoor 2 10 4 10 0 4 width 1.2\ndoor 10 5 8 1 5 0 width 0.8\n"
      "stairs 1 2 2 up 10 2\nelevator 2 9 7 up 5 2\nexit 1 0 4\nexit 10 5 0 \"Yard\"\nplace up 10 5 \"Bell\"\n");
  Result<Building> building = load_building(dir.path());
  EXPECT_TRUE(building.ok()) << building.error().to_string();
  return std::move(building).value();
}

TEST(WriteBuilding, EverythingComesBackTheSame) {
  const Building building = everything();
  ASSERT_EQ(building.rooms.size(), 4U);
  ASSERT_EQ(building.rooms[2].id, "10") << "numbers sort by value";
  ASSERT_FALSE(building.loop_closures.empty());
  expect_same(building, round_trip(building));
}

TEST(WriteBuilding, AWrittenBuildingIsWithoutFindings) {
  const test::TemporaryFolder dir;
  Result<Building> building = load_building(std::filesystem::path(ECHOWAY_MAPS_DIR) / "torgersen-lab");
  ASSERT_TRUE(write_building(*building, dir.path()).ok());
  EXPECT_THAT(check_building(dir.path()), IsEmpty());
}

TEST(WriteBuilding, OverwritesItsOwnFilesOnly) {
  const test::TemporaryFolder dir;
  Building building;
  building.rooms = {rooms::rectangle(4.0, 4.0)};
  ASSERT_TRUE(write_building(building, dir.path()).ok());
  EXPECT_TRUE(write_building(building, dir.path()).ok());
  dir.write("room-other.room", "old");
  const Status status = write_building(building, dir.path());
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().to_string(), HasSubstr("room-other.room: is not part of this building"));
}

TEST(WriteBuilding, LeavesNothingOfABuildingThatCannotBeWritten) {
  const test::TemporaryFolder dir;
  Building building;
  building.rooms = {rooms::rectangle(4.0, 4.0), rooms::rectangle(4.0, 4.0)};
  EXPECT_THAT(write_building(building, dir.path()).error().message, HasSubstr("two rooms are called"));
  building.rooms[1].id = "a b";
  EXPECT_THAT(write_building(building, dir.path()).error().message, HasSubstr("'a b'"));
  building.rooms[1].id = "Q";
  building.rooms[1].walls[0].a.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(write_building(building, dir.path()).error().message, HasSubstr("not finite"));
  building.rooms[1] = building.rooms[0];
  building.rooms[1].id = "Q";
  building.doors = {{0, {}, 7, {}, 1.0}};
  EXPECT_THAT(write_building(building, dir.path()).error().message, HasSubstr("does not exist"));
  EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
  EXPECT_FALSE(write_building(building, "/proc/nowhere/here").ok());
  building.doors.clear();
  const auto file = dir.write("taken", "");
  EXPECT_THAT(write_building(building, file).error().to_string(), HasSubstr("taken: is a file, not a folder"));
  EXPECT_THAT(write_building(building, "/proc/nowhere/here").error().to_string(),
              HasSubstr("here: cannot be made a folder: No such"));
}

}  // namespace
}  // namespace echoway
