#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "echoway/building/loader.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "echoway/random.hpp"
#include "support/process.hpp"

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
  return std::any_of(points.begin(), points.end(), [&](Vec2 p) {
    return distance(p, {feet(x_ft), feet(y_ft)}) < 1e-6;
  });
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
  const test::TemporaryFolder dir;
  dir.write("room-L.room", "6 0 0\n1 0 0 10 0\n1 10 0 10 5\n1 10 5 5 5\n1 5 5 5 10\n1 5 10 0 10\n1 0 10 0 0\n");
  dir.write("building.cfg", "");
  const Room room = load(dir.path()).rooms.at(0);
  EXPECT_EQ(room.corners.size(), 5U);
  ASSERT_EQ(room.edges.size(), 1U);
  EXPECT_TRUE(has_point(room.edges, 5, 5));
}

TEST(LoadBuilding, AStubThatCrossesAWallsEndIsAScreen) {
  const test::TemporaryFolder dir;
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
  const test::TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  dir.write("building.cfg", "# the door to nowhere\nA 10 5 B 0 5\n");
  const Result<Building> building = load_building(dir.path());
  ASSERT_FALSE(building.ok());
  EXPECT_THAT(building.error().to_string(), HasSubstr("building.cfg:2: "));
  EXPECT_THAT(building.error().message, HasSubstr("room-B.room"));
}

TEST(LoadBuilding, RefusesWallsThatDoNotClose) {
  const test::TemporaryFolder dir;
  dir.write("room-A.room", "4 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 1\n");
  dir.write("building.cfg", "");
  const Result<Building> building = load_building(dir.path());
  ASSERT_FALSE(building.ok());
  EXPECT_THAT(building.error().to_string(), HasSubstr("room-A.room:"));
  EXPECT_THAT(building.error().message, HasSubstr("do not close"));
}

TEST(LoadBuilding, ReadsMetresWhereverTheUnitStands) {
  const test::TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  dir.write("room-B.room", kSquare);
  dir.write("building.cfg", "door A 10 5 B 0 5 width 2\nplace A 1 2 \"x\"\nunits m\n");
  const Building building = load(dir.path());
  EXPECT_EQ(building.unit, LengthUnit::metres);
  EXPECT_EQ(building.rooms.at(0).walls.at(0).b, (Vec2{10.0, 0.0}));
  EXPECT_EQ(building.doors.at(0).width, 2.0);
  EXPECT_EQ(building.places.at(0).at, (Vec2{1.0, 2.0}));
  EXPECT_EQ(building.rooms.at(1).frame.position, (Vec2{10.0, 0.0}));
}

TEST(LoadBuilding, AFrameLineOverridesTheChainAndIsInherited) {
  const test::TemporaryFolder dir;
  for (const char* room : {"room-A.room", "room-B.room", "room-C.room"}) dir.write(room, kSquare);
  dir.write("building.cfg", "units m\nA 10 5 B 0 5\nB 10 5 C 0 5\nframe B 100 50 90\n");
  const Building building = load(dir.path());
  const Pose2 c = building.rooms.at(2).frame;
  EXPECT_NEAR(c.heading, degrees(90), 1e-12);
  EXPECT_NEAR(c.position.x, 100.0, 1e-9);
  EXPECT_NEAR(c.position.y, 60.0, 1e-9);
  EXPECT_NEAR(building.rooms.at(0).frame.position.y, 40.0, 1e-9);
}

TEST(LoadBuilding, LevelsHaveTheirOwnFrames) {
  const test::TemporaryFolder dir;
  for (const char* room : {"room-A.room", "room-B.room", "room-U.room", "room-V.room"}) dir.write(room, kSquare);
  dir.write("building.cfg",
            "units m\nroom U level 1 \"Up\"\nroom V level 1\nA 10 5 B 0 5\nV 10 5 U 0 5\nstairs B 5 5 U 5 5\n");
  const Building building = load(dir.path());
  EXPECT_EQ(building.rooms.at(2).level, 1);
  EXPECT_EQ(building.rooms.at(2).name, "Up");
  EXPECT_EQ(building.rooms.at(2).frame, Pose2{}) << "the first room of its level";
  EXPECT_EQ(building.rooms.at(3).frame.position, (Vec2{-10.0, 0.0}));
  ASSERT_EQ(building.links.size(), 1U);
  EXPECT_EQ(building.links[0].kind, LevelLinkKind::stairs);
}

TEST(LoadBuilding, ADoorGivenThreeTimesIsOneDoorWithTheGivenWidth) {
  const test::TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  dir.write("room-B.room", kSquare);
  dir.write("building.cfg", "B 0 5 A 10 5\nA 10 5 B 0 5\ndoor B 0 5 A 10 5 width 4\n");
  const Building building = load(dir.path());
  ASSERT_EQ(building.doors.size(), 1U);
  EXPECT_NEAR(building.doors[0].width, feet(4), 1e-12);
  for (const Room& room : building.rooms) EXPECT_EQ(room.edges.size(), 2U) << "its jambs";
  EXPECT_TRUE(has_point(building.rooms[0].edges, 10, 3));
  EXPECT_TRUE(has_point(building.rooms[0].edges, 10, 7));
}

TEST(LoadBuilding, TwoDoorsBetweenTheSameRoomsStayTwo) {
  const test::TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  dir.write("room-B.room", kSquare);
  dir.write("building.cfg", "A 10 2 B 0 2\nA 10 8 B 0 8\nB 0 8 A 10 8\n");
  EXPECT_EQ(load(dir.path()).doors.size(), 2U);
}

TEST(LoadBuilding, ADoorWithoutWidthOrEdgesIsThreeFeetWide) {
  const test::TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  dir.write("room-B.room", kSquare);
  dir.write("building.cfg", "A 10 5 B 0 5\n");
  EXPECT_NEAR(load(dir.path()).doors.at(0).width, feet(3), 1e-12);
}

TEST(LoadBuilding, TheWallsDecideWhatAMisnamedPointIs) {
  const test::TemporaryFolder dir;
  dir.write("room-L.room",
            "6 1 1\n1 0 0 10 0\n1 10 0 10 5\n1 10 5 5 5\n1 5 5 5 10\n1 5 10 0 10\n1 0 10 0 0\n2 5 5\n3 0 0\n");
  dir.write("building.cfg", "");
  const Room room = load(dir.path()).rooms.at(0);
  EXPECT_EQ(room.corners.size(), 5U);
  ASSERT_EQ(room.edges.size(), 1U);
  EXPECT_TRUE(has_point(room.edges, 5, 5));
}

TEST(LoadBuilding, OnlyRightAnglesAreCorners) {
  const test::TemporaryFolder dir;
  dir.write("room-T.room", "3 3 0\n1 0 0 20 0\n1 20 0 0 20\n1 0 20 0 0\n2 0 0\n2 20 0\n2 0 20\n");
  dir.write("building.cfg", "");
  const Room room = load(dir.path()).rooms.at(0);
  ASSERT_EQ(room.corners.size(), 1U) << "the acute ones return no sound";
  EXPECT_TRUE(has_point(room.corners, 0, 0));
}

TEST(LoadBuilding, ListedEdgesOnAWallAreKept) {
  const test::TemporaryFolder dir;
  dir.write("room-W.room", std::string("4 0 2") + std::string(kSquare.substr(5)) + "3 3 10\n3 5 10\n");
  dir.write("building.cfg", "");
  const Room room = load(dir.path()).rooms.at(0);
  EXPECT_EQ(room.edges.size(), 2U);
  EXPECT_EQ(room.corners.size(), 4U);
}

TEST(LoadBuilding, ReadsFilesFromAnySystem) {
  const test::TemporaryFolder dir;
  std::string crlf = "\xEF\xBB\xBF# drawn on another machine\r\n";
  for (const char c : kSquare) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  crlf.resize(crlf.size() - 2);  // and without an end of its last line
  dir.write("room-A.room", crlf);
  dir.write("building.cfg",
            "\xEF\xBB\xBF"
            "name \"B\xFCro\"\r\n\r\n");
  const Building building = load(dir.path());
  EXPECT_EQ(building.rooms.at(0).walls.size(), 4U);
  EXPECT_EQ(building.name, "B?ro") << "not UTF-8: mended, with a warning";
}

// --- Hostile folders
// ---------------------------------------------------------------------------------------------------

TEST(LoadBuilding, RefusesWhatIsNoText) {
  const test::TemporaryFolder dir;
  dir.write("building.cfg", "");
  for (const std::string& text : {std::string("4 0 0\n\0\0\0", 9),
                                  std::string("\x7F"
                                              "ELF\x02\x01\x01\x00",
                                              8),
                                  std::string(1'000'000, 'x'),
                                  std::string("\xFF\xFE"
                                              "4\0 \0",
                                              6),
                                  std::string("999999999999 0 0\n"), std::string("4 0 0\r1 0 0 10 0\r")}) {
    dir.write("room-A.room", text);
    const Result<Building> building = load_building(dir.path());
    ASSERT_FALSE(building.ok());
    EXPECT_THAT(building.error().to_string(), HasSubstr("room-A.room:"));
  }
}

TEST(LoadBuilding, RefusesFoldersAndPipesInPlaceOfFiles) {
  const test::TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  std::filesystem::create_directory(dir.path() / "building.cfg");
  EXPECT_THAT(load_building(dir.path()).error().to_string(), HasSubstr("building.cfg: is not a file"));
  std::filesystem::remove(dir.path() / "building.cfg");
  ASSERT_EQ(::mkfifo((dir.path() / "building.cfg").c_str(), 0600), 0);
  EXPECT_THAT(load_building(dir.path()).error().to_string(), HasSubstr("building.cfg: is not a file"));
  std::filesystem::remove(dir.path() / "building.cfg");
  std::filesystem::create_directory(dir.path() / "room-B.room");
  EXPECT_THAT(load_building(dir.path()).error().to_string(), HasSubstr("room-B.room: is not a file"));
}

TEST(LoadBuilding, RefusesEndlessFilesEarly) {
  const test::TemporaryFolder dir;
  dir.write("building.cfg", "");
  std::string text = "1000000 0 0\n";
  for (int i = 0; i < 1'000'000; ++i) text += "1 0 0 1 1\n";
  dir.write("room-A.room", text);
  EXPECT_THAT(load_building(dir.path()).error().message, HasSubstr("more than 5000 elements"));
  dir.write("room-A.room", kSquare);
  text.clear();
  for (int i = 0; i < 1'000'000; ++i) text += "A 10 5 B 0 5\n";
  dir.write("building.cfg", text);
  const std::vector<Finding> findings = check_building(dir.path());
  EXPECT_FALSE(findings.empty());
  EXPECT_LT(findings.size(), 1000U) << "a million mistakes need no million messages";
}

TEST(LoadBuilding, AnyChangeOfAFileIsSurvived) {
  Random random(17);
  const std::string room(kSquare);
  const std::string config =
      "units ft\nroom A level 1 \"Hall\"\ndoor A 10 5 B 0 5 width 3\nB 0 5 A 10 5\nframe B 10 0 0\n";
  const std::string replacements = "0123456789.-e+ \n\"#\\AB1234 nai\xFF";
  const test::TemporaryFolder dir;
  for (int round = 0; round < 400; ++round) {
    std::string texts[] = {room, room, config};
    for (auto changes = 1 + random.next() % 4; changes > 0; --changes) {
      std::string& text = texts[random.next() % 3];
      const std::size_t at = random.next() % text.size();
      const char c = replacements[random.next() % replacements.size()];
      if (random.uniform() < 0.5) {
        text[at] = c;
      } else if (random.uniform() < 0.5) {
        text.insert(at, 1, c);
      } else {
        text.erase(at, 1);
      }
    }
    dir.write("room-A.room", texts[0]);
    dir.write("room-B.room", texts[1]);
    dir.write("building.cfg", texts[2]);
    const Result<Building> building = load_building(dir.path());
    const std::vector<Finding> findings = check_building(dir.path());
    const bool unusable = !findings.empty() && findings.front().severity == Finding::Severity::unusable;
    ASSERT_EQ(building.ok(), !unusable) << texts[0] << texts[1] << texts[2];
    if (!building.ok()) continue;
    for (const Room& r : building->rooms) {
      ASSERT_TRUE(is_finite(r.frame));
      ASSERT_FALSE(r.boundary.empty());
      ASSERT_GT(signed_area(r.boundary[0]), 0.0);
    }
  }
}

}  // namespace
}  // namespace echoway
