#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include "echoway/units.hpp"
#include "import/imported.hpp"
#include "support/process.hpp"

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

// Two rooms beside each other with a door between and one out, and what a test adds, as JOSM saves them. Metres.
class DrawnPlan {
 public:
  DrawnPlan() {
    room("West", {{0, 0}, {6, 0}, {6, 5}, {0, 5}});
    room("East", {{6, 0}, {12, 0}, {12, 5}, {6, 5}});
    node({12, 2.5}, tag("entrance", "main") + tag("level", "0"));
  }

  static std::string tag(const std::string& key, const std::string& value) {
    return "<tag k='" + key + "' v='" + value + "'/>";
  }
  long node(Vec2 at, const std::string& tags = {}) {
    char place[120];
    // Degrees near 0 are the same length both ways.
    std::snprintf(place, sizeof place, "<node id='%ld' lat='%.9f' lon='%.9f'>", --id_, at.y / 110574.3,
                  at.x / 111319.5);
    text_ += place + tags + "</node>\n";
    return id_;
  }
  long door(Vec2 at, const std::string& width = "0.9") {
    return node(at, tag("door", "yes") + tag("level", "0") + tag("width", width));
  }
  long way(std::vector<long> nodes, const std::string& tags) {
    text_ += "<way id='" + std::to_string(--id_) + "'>";
    for (const long i : nodes) text_ += "<nd ref='" + std::to_string(i) + "'/>";
    text_ += tags + "</way>\n";
    return id_;
  }
  std::vector<long> ring(const std::vector<Vec2>& corners) {
    std::vector<long> nodes;
    for (const Vec2 corner : corners) nodes.push_back(node(corner));
    nodes.push_back(nodes.front());
    return nodes;
  }
  static std::string room_tags(const std::string& name) {
    return tag("indoor", "room") + tag("level", "0") + tag("name", name);
  }
  long room(const std::string& name, const std::vector<Vec2>& corners) { return way(ring(corners), room_tags(name)); }
  long relation(const std::string& members, const std::string& tags) {
    text_ += "<relation id='" + std::to_string(--id_) + "'>" + members + tags + "</relation>\n";
    return id_;
  }
  static std::string member(long way, const std::string& role) {
    return "<member type='way' ref='" + std::to_string(way) + "' role='" + role + "'/>";
  }
  void forget_node(long node) {
    const std::size_t begin = text_.find("<node id='" + std::to_string(node) + "'");
    text_.erase(begin, text_.find('\n', begin) - begin);
  }

  [[nodiscard]] ImportedPlan import(const std::string& encoding = "UTF-8") const {
    const test::TemporaryFolder folder;
    const std::string head = "<?xml version='1.0' encoding='" + encoding + "'?>\n<osm version='0.6'>\n";
    return import_plan(SourceFormat::osm, folder.write("drawn.osm", head + text_ + "</osm>\n"));
  }
  static std::string id_of(const char* type, long id) { return std::string(type) + "/" + std::to_string(id); }

 private:
  std::string text_;
  long id_ = 0;
};

std::size_t doors_of(const ImportedPlan& plan, const std::string& room) {
  const RoomIndex i = plan.building.find_room(room);
  return static_cast<std::size_t>(
      std::count_if(plan.building.doors.begin(), plan.building.doors.end(),
                    [&](const Door& door) { return door.room_a == i || door.room_b == i; }));
}

TEST(Osm, IsReadInTheEncodingThatItNames) {
  DrawnPlan drawn;
  drawn.room("B\xFCro", {{0, 5}, {6, 5}, {6, 9}, {0, 9}});
  EXPECT_THAT(drawn.import("ISO-8859-1").place_names(), Contains("B\xC3\xBCro"));
}

TEST(Osm, ARoomKeepsItsOtherCornersWhereOneIsNotInTheFile) {
  DrawnPlan drawn;
  const std::vector<long> nodes = drawn.ring({{0, 5}, {3, 4.9}, {6, 5}, {6, 9}, {0, 9}});
  const std::vector<long> turned{nodes[1], nodes[2], nodes[3], nodes[4], nodes[0], nodes[1]};
  drawn.way(turned, DrawnPlan::room_tags("North"));
  drawn.forget_node(nodes[1]);
  const ImportedPlan plan = drawn.import();
  ASSERT_NE(plan.room("0-north"), nullptr);
  EXPECT_NEAR(floor_area(*plan.room("0-north")), 24.0, 0.05);
}

TEST(Osm, ARoomOfTwoOutlinesIsThereTwice) {
  DrawnPlan drawn;
  const long west = drawn.way(drawn.ring({{0, 5}, {4, 5}, {4, 9}, {0, 9}}), "");
  const long east = drawn.way(drawn.ring({{8, 5}, {12, 5}, {12, 9}, {8, 9}}), "");
  const long column = drawn.way(drawn.ring({{9.5, 6.5}, {10.5, 6.5}, {10.5, 7.5}, {9.5, 7.5}}), "");
  drawn.relation(
      DrawnPlan::member(west, "outer") + DrawnPlan::member(east, "outer") + DrawnPlan::member(column, "inner"),
      DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("Twin"));
  drawn.door({2, 5});
  drawn.door({10, 5});
  const ImportedPlan plan = drawn.import();
  ASSERT_NE(plan.room("0-twin"), nullptr);
  ASSERT_NE(plan.room("0-twin-2"), nullptr);
  EXPECT_NEAR(floor_area(*plan.room("0-twin")), 16.0, 0.05);
  EXPECT_NEAR(floor_area(*plan.room("0-twin-2")), 15.0, 0.05);
  EXPECT_EQ(doors_of(plan, "0-twin-2"), 1U);
}

// As where the wall that two rooms share was drawn once, for both.
TEST(Osm, AnOutlineAndAHoleMayEachBeDrawnInPieces) {
  DrawnPlan drawn;
  const std::vector<long> outline = drawn.ring({{0, 5}, {8, 5}, {8, 11}, {0, 11}});
  const std::vector<long> hole = drawn.ring({{5, 7}, {7, 7}, {7, 9}, {5, 9}});
  const long door = drawn.node({2, 11}, DrawnPlan::tag("door", "yes"));  // Its level is the room's.
  const long south = drawn.way({outline[0], outline[1], outline[2]}, "");
  const long north = drawn.way({outline[0], outline[3], door, outline[2]}, "");  // Away from where the other begins.
  const long right = drawn.way({hole[0], hole[1], hole[2]}, "");
  const long left = drawn.way({hole[2], hole[3], hole[0]}, "");
  const long hall = drawn.relation(DrawnPlan::member(north, "outer") + DrawnPlan::member(left, "inner") +
                                       DrawnPlan::member(south, "outer") + DrawnPlan::member(right, "inner"),
                                   DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("Hall"));
  const ImportedPlan plan = drawn.import();
  ASSERT_NE(plan.room("0-hall"), nullptr);
  EXPECT_NEAR(floor_area(*plan.room("0-hall")), 8.0 * 6.0 - 2.0 * 2.0, 0.05);
  EXPECT_THAT(plan.room("0-hall")->boundary, SizeIs(2));
  EXPECT_THAT(plan.building.exits, SizeIs(2));
  EXPECT_FALSE(plan.unresolved(DrawnPlan::id_of("relation", hall), ""));
}

TEST(Osm, PiecesThatDoNotCloseAreListedAndWhatDoesCloseIsARoom) {
  DrawnPlan drawn;
  const std::vector<long> ring = drawn.ring({{0, 5}, {6, 5}, {6, 9}, {0, 9}});
  const long south = drawn.way({ring[0], ring[1], ring[2]}, "");
  const long north = drawn.way({ring[2], ring[3], ring[0]}, "");
  const long astray = drawn.way({ring[2], drawn.node({8, 9}), drawn.node({8, 7})}, "");
  const long slit = drawn.way({drawn.node({1, 6}), drawn.node({2, 6}), drawn.node({2, 7})}, "");
  const long other = drawn.way({drawn.node({3, 6}), drawn.node({4, 6})}, "");
  const long gone = other - 1000;
  const long room = drawn.relation(DrawnPlan::member(south, "outer") + DrawnPlan::member(astray, "outer") +
                                       DrawnPlan::member(north, "outer") + DrawnPlan::member(south, "outer") +
                                       DrawnPlan::member(slit, "inner") + DrawnPlan::member(other, "inner") +
                                       DrawnPlan::member(gone, "outer"),
                                   DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("North"));
  drawn.door({3, 5});
  const ImportedPlan plan = drawn.import();
  ASSERT_NE(plan.room("0-north"), nullptr);
  EXPECT_NEAR(floor_area(*plan.room("0-north")), 24.0, 0.05);
  const std::string id = DrawnPlan::id_of("relation", room);
  EXPECT_TRUE(plan.unresolved(id, "an outline of way " + std::to_string(astray) + " does not close: left out"));
  EXPECT_TRUE(plan.unresolved(id, "a hole of way " + std::to_string(slit) + " and 1 more does not close: left out"));
  EXPECT_TRUE(plan.unresolved(id, "member " + std::to_string(gone) + " is no way of the file: left out"));
  EXPECT_THAT(plan.report.items(), SizeIs(3));
}

// Which pieces belong together is not to be told then: the same ones in whatever order a program saved them.
TEST(Osm, OfThreePiecesBetweenTwoNodesTheSameOnesCloseInAnyOrder) {
  std::vector<std::size_t> order{0, 1, 2};
  do {
    DrawnPlan drawn;
    const long begin = drawn.node({0, 5}), end = drawn.node({6, 5});
    std::vector<long> ways;
    for (const double north : {5.0, 9.0, 12.0}) {
      ways.push_back(drawn.way({begin, drawn.node({0, north}), drawn.node({6, north}), end}, ""));
    }
    std::string members;
    for (const std::size_t i : order) members += DrawnPlan::member(ways[i], "outer");
    const long room = drawn.relation(members, DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("North"));
    drawn.door({3, 5});
    const ImportedPlan plan = drawn.import();
    ASSERT_NE(plan.room("0-north"), nullptr);
    EXPECT_NEAR(floor_area(*plan.room("0-north")), 24.0, 0.05);
    EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("relation", room),
                                "an outline of way " + std::to_string(ways[2]) + " does not close: left out"));
  } while (std::next_permutation(order.begin(), order.end()));
}

// As by those who said it on what they drew first.
TEST(Osm, ARoomWhoseOutlineSaysThatItIsOneIsThereOnceAndNothingIsListed) {
  for (const bool in_pieces : {false, true}) {
    SCOPED_TRACE(in_pieces);
    DrawnPlan drawn;
    const std::vector<long> ring = drawn.ring({{0, 5}, {6, 5}, {6, 9}, {0, 9}});
    const long column = drawn.way(drawn.ring({{2, 6}, {3, 6}, {3, 7}, {2, 7}}), "");
    std::string members = DrawnPlan::member(column, "inner");
    if (in_pieces) {
      const long south = drawn.way({ring[0], ring[1], ring[2]}, DrawnPlan::room_tags("North"));
      const long north = drawn.way({ring[2], ring[3], ring[0]}, DrawnPlan::tag("indoor", "room"));
      members += DrawnPlan::member(south, "outer") + DrawnPlan::member(north, "outer");
    } else {
      members += DrawnPlan::member(drawn.way(ring, DrawnPlan::room_tags("North")), "outer");
    }
    drawn.relation(members, DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("North"));
    drawn.door({5, 5});
    const ImportedPlan plan = drawn.import();
    EXPECT_THAT(plan.room_ids(), UnorderedElementsAre("0-west", "0-east", "0-north"));
    ASSERT_NE(plan.room("0-north"), nullptr);
    EXPECT_NEAR(floor_area(*plan.room("0-north")), 23.0, 0.05);
    EXPECT_THAT(plan.report.items(), SizeIs(0));
  }
}

// A room in the middle of another, as the hole in which it stands.
TEST(Osm, AHoleThatIsARoomIsOne) {
  DrawnPlan drawn;
  const long outline = drawn.way(drawn.ring({{0, 5}, {6, 5}, {6, 9}, {0, 9}}), "");
  const long cabin = drawn.room("North", {{2, 6}, {4, 6}, {4, 8}, {2, 8}});
  drawn.relation(DrawnPlan::member(outline, "outer") + DrawnPlan::member(cabin, "inner"),
                 DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("North"));
  drawn.door({1, 5});
  drawn.door({3, 6});
  EXPECT_THAT(drawn.import().room_ids(), UnorderedElementsAre("0-west", "0-east", "0-north", "0-north-2"));
}

// It would otherwise be gone without a word, or be a room by itself.
TEST(Osm, AHoleOutsideItsOutlinesIsListed) {
  DrawnPlan drawn;
  const long west = drawn.way(drawn.ring({{0, 5}, {4, 5}, {4, 9}, {0, 9}}), "");
  const long east = drawn.way(drawn.ring({{8, 5}, {12, 5}, {12, 9}, {8, 9}}), "");
  const long astray = drawn.way(drawn.ring({{5, 6}, {7, 6}, {7, 8}, {5, 8}}), "");
  const std::string tags = DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("Holed");
  const std::string hole = DrawnPlan::member(astray, "inner");
  const long twin = drawn.relation(DrawnPlan::member(west, "outer") + DrawnPlan::member(east, "outer") + hole, tags);
  const long single = drawn.relation(DrawnPlan::member(west, "outer") + hole, tags);
  const ImportedPlan plan = drawn.import();
  EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("relation", twin), "a hole lies outside its outline"));
  EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("relation", single), "a hole lies outside its outline"));
  for (const Room& room : plan.building.rooms) EXPECT_GT(floor_area(room), 15.0) << room.id;
}

TEST(Osm, AnAreaOfHolesOnlyIsListed) {
  DrawnPlan drawn;
  const long hole = drawn.way(drawn.ring({{1, 6}, {3, 6}, {3, 8}, {1, 8}}), "");
  const long room = drawn.relation(DrawnPlan::member(hole, "inner"),
                                   DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("Hollow"));
  const ImportedPlan plan = drawn.import();
  EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("relation", room), "has no outline: left out"));
  EXPECT_THAT(plan.room_ids(), UnorderedElementsAre("0-west", "0-east"));
}

TEST(Osm, AHoleThatReachesOverItsOutlineTakesOutWhatLiesInIt) {
  DrawnPlan drawn;
  const long outline = drawn.way(drawn.ring({{0, 5}, {4, 5}, {4, 9}, {0, 9}}), "");
  const long shaft = drawn.way(drawn.ring({{3, 6}, {6, 6}, {6, 8}, {3, 8}}), "");
  drawn.relation(DrawnPlan::member(outline, "outer") + DrawnPlan::member(shaft, "inner"),
                 DrawnPlan::tag("type", "multipolygon") + DrawnPlan::room_tags("North"));
  drawn.door({2, 5});
  const ImportedPlan plan = drawn.import();
  EXPECT_THAT(plan.room_ids(), UnorderedElementsAre("0-west", "0-east", "0-north"));
  EXPECT_NEAR(floor_area(*plan.room("0-north")), 14.0, 0.05);
}

TEST(Osm, RoomsThatItCannotTakeAreListed) {
  DrawnPlan drawn;
  std::vector<long> nodes = drawn.ring({{0, 5}, {6, 5}, {6, 9}, {0, 9}});
  nodes.pop_back();
  const long open = drawn.way(nodes, DrawnPlan::room_tags("Open"));
  const long vague = drawn.way(drawn.ring({{6, 5}, {12, 5}, {12, 9}, {6, 9}}),
                               DrawnPlan::tag("indoor", "yes") + DrawnPlan::tag("level", "0"));
  const ImportedPlan plan = drawn.import();
  EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("way", open), "does not return to its first node"));
  EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("way", vague), "indoor=yes"));
}

TEST(Osm, ADoorWhoseWidthIsNoneIsThereWithTheUsualOne) {
  for (const char* width : {"90", "0,9", "wide", "-1"}) {
    DrawnPlan drawn;
    const long door = drawn.door({6, 2.5}, width);
    const ImportedPlan plan = drawn.import();
    ASSERT_THAT(plan.doors_between("0-west", "0-east"), SizeIs(1)) << width;
    EXPECT_NEAR(plan.doors_between("0-west", "0-east")[0].width, feet(3.0), 1e-3) << width;
    EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("node", door), std::string("width=") + width)) << width;
  }
}

// At a corner of the wall as drawn, and in the middle of one of its pieces, where the door is wider than the piece:
// beside it, the wall has already turned away.
TEST(Osm, ADoorInARoundWallIsFound) {
  constexpr int kPieces = 120;
  constexpr double kPiece = 360.0 / kPieces;
  const auto at = [](double angle, double radius) {
    return Vec2{30.0 + radius * std::cos(degrees(angle)), radius * std::sin(degrees(angle))};
  };
  std::vector<Vec2> circle;
  for (int i = 0; i < kPieces; ++i) circle.push_back(at(kPiece * i, 5.0));
  const Vec2 corner = at(15 * kPiece, 5.0), middle = at(15.5 * kPiece, 5.0 * std::cos(degrees(0.5 * kPiece)));
  for (const Vec2 place : {corner, middle}) {
    DrawnPlan drawn;
    drawn.room("Tower", circle);
    drawn.room("Court", {{24, -6}, {36, -6}, {36, 6}, {24, 6}});
    const long door = drawn.door(place);
    const ImportedPlan plan = drawn.import();
    ASSERT_THAT(plan.doors_between("0-tower", "0-court"), SizeIs(1)) << place.x << ' ' << place.y;
    EXPECT_FALSE(plan.repaired(DrawnPlan::id_of("node", door), "off its wall"));
    expect_sound(plan.building);
  }
}

// West's wall is at y = 5; the vault's is as much further north as the wall is thick.
DrawnPlan with_vault(double wall) {
  DrawnPlan drawn;
  drawn.room("Vault", {{0, 5.0 + wall}, {6, 5.0 + wall}, {6, 12}, {0, 12}});
  return drawn;
}

// Only the front door is a way out.
void expect_one_door_from_west(const ImportedPlan& plan, const std::string& to) {
  EXPECT_THAT(plan.doors_between("0-west", to), SizeIs(1));
  EXPECT_THAT(plan.building.exits, SizeIs(1));
  expect_sound(plan.building);
}

TEST(Osm, ADoorInAThickWallJoinsTheRoomsOnItsSides) {
  for (const double wall : {0.5, 0.8, 1.15}) {
    SCOPED_TRACE(wall);
    DrawnPlan one = with_vault(wall);
    one.door({3, 5});
    expect_one_door_from_west(one.import(), "0-vault");
    // On the outlines of both rooms, as where each was drawn for itself.
    DrawnPlan both = with_vault(wall);
    both.door({3, 5});
    both.door({3, 5.0 + wall});
    expect_one_door_from_west(both.import(), "0-vault");
    DrawnPlan with_wall = with_vault(wall);
    with_wall.way(with_wall.ring({{0, 5}, {6, 5}, {6, 5.0 + wall}, {0, 5.0 + wall}}),
                  DrawnPlan::tag("indoor", "wall") + DrawnPlan::tag("level", "0"));
    with_wall.door({3, 5.0 + 0.5 * wall});
    expect_one_door_from_west(with_wall.import(), "0-vault");
  }
}

TEST(Osm, ADoorInTheMiddleOfAWallTooThickForOneIsListed) {
  DrawnPlan drawn = with_vault(1.4);
  drawn.way(drawn.ring({{0, 5}, {6, 5}, {6, 6.4}, {0, 6.4}}),
            DrawnPlan::tag("indoor", "wall") + DrawnPlan::tag("level", "0"));
  const long door = drawn.door({3, 5.7});
  const ImportedPlan plan = drawn.import();
  EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("node", door), "leads into a wall"));
  EXPECT_THAT(plan.building.exits, SizeIs(1));
}

// A chamber in the masonry, a metre behind West's wall at y = 5: to the right of x = 3 + `offset` or, mirrored, to the
// left of x = 3 - `offset`.
DrawnPlan with_chamber(double offset, bool mirrored) {
  const auto at = [mirrored](double x, double y) { return Vec2{mirrored ? 6.0 - x : x, y}; };
  const double side = 3.0 + offset;
  DrawnPlan drawn;
  drawn.room("Chamber", {at(side, 6), at(6, 6), at(6, 9), at(side, 9)});
  drawn.way(drawn.ring({at(0, 5), at(6, 5), at(6, 6), at(side, 6), at(side, 9), at(0, 9)}),
            DrawnPlan::tag("indoor", "wall") + DrawnPlan::tag("level", "0"));
  return drawn;
}

TEST(Osm, ADoorLeadsWhereMostOfItsWidthDoesOnWhicheverSideThatIs) {
  for (const bool mirrored : {false, true}) {
    SCOPED_TRACE(mirrored);
    DrawnPlan open = with_chamber(-0.1, mirrored);
    open.door({3, 5}, "0.9");
    expect_one_door_from_west(open.import(), "0-chamber");
    DrawnPlan walled = with_chamber(0.1, mirrored);
    const long door = walled.door({3, 5}, "0.9");
    const ImportedPlan plan = walled.import();
    EXPECT_THAT(plan.doors_between("0-west", "0-chamber"), SizeIs(0));
    EXPECT_TRUE(plan.unresolved(DrawnPlan::id_of("node", door), "leads into a wall"));
  }
}

TEST(Osm, ADoorIntoAnAlleyBetweenTwoRoomsIsAWayOut) {
  DrawnPlan drawn = with_vault(2.0);
  drawn.door({3, 5});
  const ImportedPlan plan = drawn.import();
  EXPECT_THAT(plan.doors_between("0-west", "0-vault"), SizeIs(0));
  EXPECT_THAT(plan.building.exits, SizeIs(2));
}

// Whoever is led out of a fire ends up in it.
TEST(Osm, ADoorIntoACourtIsAWayOutOnlyWhenThePlanSaysSo) {
  const std::string level = DrawnPlan::tag("level", "0");
  for (const bool entrance : {false, true}) {
    DrawnPlan drawn;
    drawn.room("Left", {{0, 5}, {3, 5}, {3, 9}, {0, 9}});
    drawn.room("Right", {{9, 5}, {12, 5}, {12, 9}, {9, 9}});
    drawn.room("Back", {{0, 9}, {12, 9}, {12, 12}, {0, 12}});
    const long door = drawn.node({4.5, 5}, level + DrawnPlan::tag(entrance ? "entrance" : "door", "yes"));
    const ImportedPlan plan = drawn.import();
    EXPECT_THAT(plan.building.exits, SizeIs(entrance ? 2 : 1));
    EXPECT_EQ(plan.unresolved(DrawnPlan::id_of("node", door), "leads into a court"), !entrance);
  }
}

// The wall between two rooms meets the outer wall half a metre beside it, and joins two rooms.
TEST(Osm, ADoorInTheOuterWallBesideAPartitionLeadsOut) {
  for (const char* key : {"entrance", "door"}) {
    DrawnPlan drawn;
    const long door = drawn.node({6.5, 0}, DrawnPlan::tag(key, "yes") + DrawnPlan::tag("level", "0"));
    const ImportedPlan plan = drawn.import();
    EXPECT_THAT(plan.building.exits, SizeIs(2)) << key;
    EXPECT_THAT(plan.doors_between("0-west", "0-east"), SizeIs(0)) << key;
    EXPECT_FALSE(plan.repaired(DrawnPlan::id_of("node", door), "off its wall")) << key;
  }
}

TEST(Osm, AnEntranceThatStandsOffTheOuterWallBesideAPartitionLeadsOut) {
  DrawnPlan drawn;
  drawn.node({6.4, 0.3}, DrawnPlan::tag("entrance", "yes") + DrawnPlan::tag("level", "0"));
  const ImportedPlan plan = drawn.import();
  EXPECT_THAT(plan.building.exits, SizeIs(2));
  EXPECT_THAT(plan.doors_between("0-west", "0-east"), SizeIs(0));
}

}  // namespace
}  // namespace echoway::import
