#include "import/imported.hpp"

namespace echoway::import {
namespace {

using testing::Contains;
using testing::SizeIs;
using testing::UnorderedElementsAre;

ImportedPlan cottage() { return import_plan(SourceFormat::wrld, test_plan("cottage")); }

// The plan draws walls, windows and doors only; the rooms are what these enclose.
TEST(Wrld, WallsAndDoorsEncloseRooms) {
  const ImportedPlan plan = cottage();
  EXPECT_THAT(plan.room_ids(), UnorderedElementsAre("g-office", "g-corridor", "g-toilet", "g-room-1", "g-room-2",
                                                    "1-shop", "1-room-1"));
  expect_sound(plan.building);
  EXPECT_NEAR(floor_area(*plan.room("g-toilet")), 4.6 * 3.6 + 0.2, 0.05);  // with the depth of its doorway
  EXPECT_TRUE(plan.findings.empty());
}

TEST(Wrld, DoorsJoinTheRoomsOnBothSidesOfAWall) {
  const ImportedPlan plan = cottage();
  EXPECT_THAT(plan.doors_between("g-office", "g-corridor"), SizeIs(1));
  EXPECT_THAT(plan.doors_between("g-toilet", "g-room-2"), SizeIs(1));
  const std::vector<Door> leaves = plan.doors_between("g-room-1", "g-corridor");
  ASSERT_THAT(leaves, SizeIs(1));
  EXPECT_NEAR(leaves[0].width, 1.0, 0.01);  // two leaves of half a metre
}

// `unit` stands for walls along its outline, `room` and `hallway` only name what walls enclose.
TEST(Wrld, UnitsHaveWallsOfTheirOwn) {
  const ImportedPlan plan = cottage();
  EXPECT_NEAR(floor_area(*plan.room("1-shop")), 5.8 * 4.8, 0.2);
  EXPECT_THAT(plan.doors_between("1-shop", "1-room-1"), SizeIs(1));
}

TEST(Wrld, GapsThatNobodyFitsThroughAreClosedAndListed) {
  const ImportedPlan plan = cottage();
  EXPECT_TRUE(plan.repaired("1009", "to 51"));   // 2 cm between two walls
  EXPECT_TRUE(plan.repaired("1004", "to 52"));   // a wall that ends 30 cm short of the next
  EXPECT_THAT(plan.doors_between("g-office", "g-room-1"), SizeIs(0));
  EXPECT_TRUE(plan.unresolved("99", "'aquarium' is not known"));
}

TEST(Wrld, AnOuterDoorIsAWayOutAndStairsAboveStairsJoinLevels) {
  const ImportedPlan plan = cottage();
  EXPECT_THAT(plan.exit_names(), UnorderedElementsAre("Front door"));
  ASSERT_THAT(plan.building.links, SizeIs(1));
  EXPECT_EQ(plan.building.room(plan.building.links[0].room_a).id, "g-room-2");
  EXPECT_EQ(plan.building.room(plan.building.links[0].room_b).id, "1-room-1");
}

}  // namespace
}  // namespace echoway::import
