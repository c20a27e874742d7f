#include "import/imported.hpp"

namespace echoway::import {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::UnorderedElementsAre;

ImportedPlan city_library() { return import_plan(SourceFormat::imdf, test_plan("city-library")); }

TEST(Imdf, UnitsBecomeClosedRoomsOnTheirLevels) {
  const ImportedPlan plan = city_library();
  EXPECT_EQ(plan.building.name, "City Library");
  EXPECT_THAT(plan.room_ids(),
              UnorderedElementsAre("g-office-0.12", "g-toilet", "g-stairs", "g-elevator", "g-book-store",
                                   "g-cafe-lumiere", "g-foyer", "g-reading-room", "1-studio", "1-stairs", "1-elevator",
                                   "1-gallery"));
  expect_sound(plan.building);
  ASSERT_NE(plan.room("1-studio"), nullptr);
  EXPECT_EQ(plan.room("1-studio")->level, 1);
  EXPECT_EQ(plan.room("1-studio")->name, "Studio");
  EXPECT_THAT(plan.findings, IsEmpty());
}

// The hall is open to the foyer, so the two are one space; the column and the opening to below are no floor.
TEST(Imdf, OpenUnitsRunTogetherAndColumnsStandInRooms) {
  const ImportedPlan plan = city_library();
  EXPECT_NEAR(floor_area(*plan.room("g-foyer")), 8.0 * 5.0 + 20.0 * 2.0, 0.5);
  EXPECT_NEAR(floor_area(*plan.room("g-reading-room")), 11.8 * 4.8 - 0.16 + 1.2 * 0.2, 0.05);
  EXPECT_NEAR(floor_area(*plan.room("1-gallery")), 20.0 * 2.0 - 4.0 * 1.6 + 0.9 * 0.2, 0.05);
}

TEST(Imdf, OpeningsBecomeDoorsSeenFromBothRooms) {
  const ImportedPlan plan = city_library();
  const std::vector<Door> doors = plan.doors_between("g-reading-room", "g-foyer");
  ASSERT_THAT(doors, SizeIs(1));
  EXPECT_NEAR(doors[0].width, 1.2, 0.01);
  for (const char* room : {"g-office-0.12", "g-toilet", "g-stairs", "g-elevator", "g-book-store", "g-cafe-lumiere"}) {
    EXPECT_THAT(plan.doors_between(room, "g-foyer"), SizeIs(1)) << room;
  }
  EXPECT_THAT(plan.doors_between("1-studio", "1-gallery"), SizeIs(1));
}

TEST(Imdf, StairsAndElevatorsJoinLevels) {
  const ImportedPlan plan = city_library();
  ASSERT_THAT(plan.building.links, SizeIs(2));
  for (const LevelLink& link : plan.building.links) {
    const std::string& a = plan.building.room(link.room_a).id;
    EXPECT_EQ(a, link.kind == LevelLinkKind::stairs ? "g-stairs" : "g-elevator");
    EXPECT_EQ(plan.building.room(link.room_b).level, 1);
  }
}

TEST(Imdf, WaysOutAndPlacesHaveTheirNames) {
  const ImportedPlan plan = city_library();
  EXPECT_THAT(plan.exit_names(), UnorderedElementsAre("Main entrance", ""));
  for (const char* place :
       {"Foyer", "Reading Room", "Office 0.12", "Toilet", "Stairs, Ground floor", "Stairs, First floor", "Café Lumière",
        "Book Corner", "Information desk", "Cash machine", "Studio"}) {
    EXPECT_THAT(plan.place_names(), Contains(place));
  }
  EXPECT_THAT(plan.place_names(), Not(Contains("Lost")));
}

TEST(Imdf, FurnitureReflectsAtAnyIncidence) {
  const ImportedPlan plan = city_library();
  EXPECT_THAT(plan.room("g-reading-room")->reflectors, SizeIs(8));  // a desk and a shelf
  EXPECT_THAT(plan.room("g-foyer")->reflectors, SizeIs(4));         // the information kiosk
}

TEST(Imdf, EveryRepairIsListedWithItsFeatureAndPlace) {
  const ImportedPlan plan = city_library();
  EXPECT_TRUE(plan.repaired("u-reading", "repeated point"));
  EXPECT_TRUE(plan.repaired("u-studio", "crosses itself"));
  EXPECT_TRUE(plan.repaired("u-store", "overlaps unit u-lift-0"));
  EXPECT_TRUE(plan.repaired("o-office", "0.30 m off its wall"));
  EXPECT_TRUE(plan.repaired("", "outlines run clockwise"));
  for (const ReportItem& item : plan.report.items()) {
    EXPECT_THAT(item.source.file, testing::HasSubstr("city-library")) << item.to_string();
    const bool of_a_feature = item.kind == ReportItem::Kind::repaired && !item.source.id.empty();
    EXPECT_TRUE(item.at.has_value() || !of_a_feature) << item.to_string();
  }
}

TEST(Imdf, WhatStaysOpenIsListed) {
  const ImportedPlan plan = city_library();
  EXPECT_TRUE(plan.unresolved("u-nowhere", "level-9"));
  EXPECT_TRUE(plan.unresolved("o-stray", "off every wall"));
  EXPECT_TRUE(plan.unresolved("oc-lost", "no anchor"));
  EXPECT_TRUE(plan.unresolved("am-lost", "no unit"));
  EXPECT_TRUE(plan.unresolved("r-lost", "not in this plan"));
  EXPECT_TRUE(plan.unresolved("f-outside", "no room"));
}

TEST(Imdf, AnArchiveIsTheSameAsItsFolder) {
  const ImportedPlan folder = city_library();
  const ImportedPlan archive = import_plan(SourceFormat::imdf, test_plan("city-library.zip"));
  EXPECT_EQ(archive.room_ids(), folder.room_ids());
  EXPECT_EQ(archive.building.doors.size(), folder.building.doors.size());
  ASSERT_EQ(archive.building.rooms.size(), folder.building.rooms.size());
  for (std::size_t i = 0; i < folder.building.rooms.size(); ++i) {
    EXPECT_EQ(archive.building.rooms[i].walls, folder.building.rooms[i].walls);
  }
}

}  // namespace
}  // namespace echoway::import
