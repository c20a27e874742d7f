#include "import/imported.hpp"

namespace echoway::import {
namespace {

using testing::Contains;
using testing::IsSupersetOf;
using testing::SizeIs;
using testing::UnorderedElementsAre;

ImportedPlan hill_school() { return import_plan(SourceFormat::osm, test_plan("hill-school.osm")); }

TEST(Osm, RoomsCorridorsAndAreasBecomeClosedRooms) {
  const ImportedPlan plan = hill_school();
  EXPECT_EQ(plan.building.name, "Hill School");
  EXPECT_THAT(plan.room_ids(),
              UnorderedElementsAre("0-class-1a", "0-class-1b", "0-toilet", "0-stairs", "0-bureau-sud", "0-cellar",
                                   "0-main-corridor", "1-upper-corridor", "1-hall", "1-toilet", "1-stairs"));
  expect_sound(plan.building);
}

// The lounge is open to the corridor; the courtyard in the corridor's middle and the screen in the lounge are no floor.
TEST(Osm, MultipolygonsKeepTheirHolesAndOpenAreasRunTogether) {
  const ImportedPlan plan = hill_school();
  const Room& corridor = *plan.room("0-main-corridor");
  EXPECT_NEAR(floor_area(corridor), 24.0 * 4.0 - 6.0 * 1.2 + 6.0 * 5.0 - 2.0 * 0.1, 0.05);
  EXPECT_THAT(corridor.boundary, SizeIs(3));
  EXPECT_THAT(plan.place_names(), IsSupersetOf({"Lounge", "Drinks", "Main corridor", "Bureau 'Süd'"}));
}

TEST(Osm, DoorNodesBecomeDoorsWithTheirWidths) {
  const ImportedPlan plan = hill_school();
  const auto width = [&](const char* room, const char* corridor) {
    const std::vector<Door> doors = plan.doors_between(room, corridor);
    return doors.size() == 1 ? doors[0].width : 0.0;
  };
  EXPECT_NEAR(width("0-class-1a", "0-main-corridor"), 0.8, 1e-3);
  EXPECT_NEAR(width("0-class-1b", "0-main-corridor"), feet(3.0), 1e-3);  // not said
  EXPECT_NEAR(width("0-toilet", "0-main-corridor"), 1.1, 1e-3);          // "110 cm"
  EXPECT_NEAR(width("1-hall", "1-upper-corridor"), 1.8, 1e-3);
  EXPECT_THAT(plan.doors_between("0-bureau-sud", "0-main-corridor"), SizeIs(2));
}

// repeat_on puts a room and the doors on its outline on every level that it names.
TEST(Osm, RepeatedFeaturesStandOnEveryLevel) {
  const ImportedPlan plan = hill_school();
  EXPECT_EQ(plan.room("1-toilet")->level, 1);
  EXPECT_THAT(plan.doors_between("1-toilet", "1-upper-corridor"), SizeIs(1));
}

TEST(Osm, AWayOverTwoLevelsAndAnElevatorNodeJoinThem) {
  const ImportedPlan plan = hill_school();
  ASSERT_THAT(plan.building.links, SizeIs(2));
  for (const LevelLink& link : plan.building.links) {
    const bool stairs = link.kind == LevelLinkKind::stairs;
    EXPECT_EQ(plan.building.room(link.room_a).id, stairs ? "0-stairs" : "0-main-corridor");
    EXPECT_EQ(plan.building.room(link.room_b).id, stairs ? "1-stairs" : "1-upper-corridor");
  }
}

TEST(Osm, AnEntranceIsAWayOut) { EXPECT_THAT(hill_school().exit_names(), UnorderedElementsAre("North door")); }

TEST(Osm, DirtIsRepairedOrListedWithItsLine) {
  const ImportedPlan plan = hill_school();
  EXPECT_TRUE(plan.repaired("node/138", "0.30 m off its wall"));
  EXPECT_TRUE(plan.unresolved("node/137", "off every wall"));
  EXPECT_TRUE(plan.unresolved("way/35", "no door leads into"));
  EXPECT_TRUE(plan.unresolved("way/42", "level=1st"));
  EXPECT_TRUE(plan.unresolved("way/43", "no level"));
  EXPECT_TRUE(plan.unresolved("way/44", "99999"));
  for (const ReportItem& item : plan.report.items()) {
    EXPECT_TRUE(item.source.id.empty() || item.source.file.find("hill-school.osm:") != std::string::npos);
  }
}

}  // namespace
}  // namespace echoway::import
