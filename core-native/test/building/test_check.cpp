// Each finding of check_building(): where it stands, what it says, whether the building stays usable.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "echoway/building/loader.hpp"
#include "support/process.hpp"

namespace echoway {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A room of 10 by 10 ft with its corners listed, from line 2 on.
constexpr std::string_view kSquare =
    "4 4 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n2 0 0\n2 10 0\n2 10 10\n2 0 10\n";

/// Findings as `file:line: message` without the folder; unusable ones are marked.
class CheckBuilding : public testing::Test {
 protected:
  void room(std::string_view id, std::string_view text) { dir_.write("room-" + std::string(id) + ".room", text); }
  void config(std::string_view text) { dir_.write("building.cfg", text); }

  /// Rooms A and B side by side, the door in the middle of the wall between them.
  void two_rooms() {
    room("A", kSquare);
    room("B", kSquare);
    config("A 10 5 B 0 5\nB 0 5 A 10 5\n");
  }

  [[nodiscard]] std::vector<std::string> findings() const {
    std::vector<std::string> out;
    for (const Finding& finding : check_building(dir_.path())) {
      const std::string text = finding.to_string();
      const std::string prefix = dir_.path().string() + "/";
      const bool unusable = finding.severity == Finding::Severity::unusable;
      out.push_back((unusable ? "UNUSABLE " : "") + (text.starts_with(prefix) ? text.substr(prefix.size()) : text));
    }
    const bool any_unusable = std::any_of(out.begin(), out.end(), [](const auto& s) { return s.starts_with("UNU"); });
    EXPECT_EQ(load_building(dir_.path()).ok(), !any_unusable);
    return out;
  }

  test::TemporaryFolder dir_;
};

TEST_F(CheckBuilding, FindsNothingInAGoodBuilding) {
  two_rooms();
  EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(CheckBuilding, SaysOfWhatKindAFindingIs) {
  using Kind = Finding::Kind;
  const auto kinds = [&] {
    std::vector<Kind> out;
    for (const Finding& finding : check_building(dir_.path())) out.push_back(finding.kind);
    return out;
  };
  EXPECT_THAT(kinds(), ElementsAre(Kind::no_rooms));
  two_rooms();
  config("A 10 5 B 0 5\nB 0 5 A 10 5\nexit Z 1 1\nplace A 50 50 \"\"\n");
  EXPECT_THAT(kinds(), ElementsAre(Kind::unknown_room, Kind::off_floor, Kind::name));
  config("A 10 5 B 0 5\nB 0 5.5 A 10 5\n");
  EXPECT_THAT(kinds(), ElementsAre(Kind::door_lines));
  config("A 5 5 B 0 5\n");
  EXPECT_THAT(kinds(), Contains(Kind::door_position));
  config("");
  EXPECT_THAT(kinds(), Contains(Kind::unreachable));
  room("A", "four 0 0\n");
  room("B", "3 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n");
  EXPECT_THAT(kinds(), ElementsAre(Kind::bad_line, Kind::open_walls));
}

// --- Unusable
// ----------------------------------------------------------------------------------------------------------

TEST_F(CheckBuilding, AFolderThatIsNotThere) {
  const std::vector<Finding> all = check_building(dir_.path() / "nowhere");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].severity, Finding::Severity::unusable);
  EXPECT_THAT(all[0].to_string(), HasSubstr("nowhere: cannot be read"));
}

TEST_F(CheckBuilding, AFolderWithoutRooms) {
  config("");
  EXPECT_THAT(findings(), ElementsAre(AllOf(HasSubstr("UNUSABLE"), HasSubstr("has no room files"))));
}

TEST_F(CheckBuilding, CountsThatDoNotMatch) {
  room("A", "5 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n");
  config("");
  EXPECT_THAT(findings(), Contains(HasSubstr("UNUSABLE room-A.room:1: says 5 walls but the file has 4")));
}

TEST_F(CheckBuilding, ReflectorsThatAreNotCounted) {
  room("A", std::string(kSquare) + "4 2 2 4 2\n");
  config("");
  EXPECT_THAT(findings(), Contains(HasSubstr("UNUSABLE room-A.room:1: says 0 reflectors but the file has 1")));
}

TEST_F(CheckBuilding, MalformedLinesOfARoom) {
  room("A",
       "4 0 0\n1 0 0 10\n1 10 0 10 10 10\n7 1 2\n1 0 ten 0 0\n1 0 nan 0 0\n1 0 1e999 0 0\n1 0x10 0 0 0\n1 1,5 0 0 0\n"
       "2 1\n");
  config("");
  EXPECT_THAT(
      findings(),
      ElementsAre(HasSubstr("room-A.room:2: y2 is missing"), HasSubstr("room-A.room:3: '10' is one word too many"),
                  HasSubstr("room-A.room:4: '7' is no kind of element"),
                  HasSubstr("room-A.room:5: y1 is 'ten', not a finite number"), HasSubstr("room-A.room:6: y1 is 'nan'"),
                  HasSubstr("room-A.room:7: y1 is '1e999'"), HasSubstr("room-A.room:8: x1 is '0x10'"),
                  HasSubstr("room-A.room:9: x1 is '1,5'"), HasSubstr("room-A.room:10: y is missing")));
}

TEST_F(CheckBuilding, CoordinatesThatNoBuildingHas) {
  room("A", "4 0 0\n1 0 0 1e308 0\n1 1e308 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n");
  config("");
  EXPECT_THAT(findings(), Contains(HasSubstr("UNUSABLE room-A.room:2: x2 is '1e308', too far away")));
}

TEST_F(CheckBuilding, AFirstLineThatIsNoCounts) {
  room("A", "1 0 0 10 0\n");
  room("B", "four 0 0\n");
  room("C", "-4 0 0\n");
  room("D", "# nothing here\n\n");
  config("");
  EXPECT_THAT(findings(), testing::IsSupersetOf({HasSubstr("UNUSABLE room-A.room:1: '"),
                                                 HasSubstr("UNUSABLE room-B.room:1: the number of walls is 'four'"),
                                                 HasSubstr("UNUSABLE room-C.room:1: the number of walls is negative"),
                                                 HasSubstr("UNUSABLE room-D.room:1: is empty")}));
}

TEST_F(CheckBuilding, WallsThatDoNotClose) {
  room("A", "4 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0.7\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(AllOf(HasSubstr("UNUSABLE room-A.room:"), HasSubstr("do not close"),
                                            HasSubstr("(the nearest is 0.7 ft away)"))));
}

TEST_F(CheckBuilding, AColumnDoesNotMakeAFloorOfAnOpenOutline) {
  room("A", "7 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 4 4 5 4\n1 5 4 5 5\n1 5 5 4 5\n1 4 5 4 4\n");
  config("");
  EXPECT_THAT(findings(), Contains(AllOf(HasSubstr("UNUSABLE"), HasSubstr("do not close"))));
}

TEST_F(CheckBuilding, ADoorToARoomWithoutAFile) {
  room("A", kSquare);
  config("\nA 10 5 B 0 5\n");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("UNUSABLE building.cfg:2: a door leads to room 'B'")));
}

TEST_F(CheckBuilding, MalformedLinesOfTheConfiguration) {
  room("A", kSquare);
  config(
      "units furlongs\nA 10 5 B 0\nfrobnicate 3\ndoor A 1 2 B 3 4\nroom A level two\nplace A 1 1 Lectern\n"
      "exit A 1 x\nframe A 0 0\nname \"open\nplace A 1 1 \"x\" y\nroom A floor 2\n");
  EXPECT_THAT(
      findings(),
      ElementsAre(HasSubstr("building.cfg:1: the unit is 'furlongs', not ft or m"), HasSubstr("building.cfg:2: "),
                  HasSubstr("building.cfg:3: 'frobnicate'"), HasSubstr("building.cfg:4: width is missing"),
                  HasSubstr("building.cfg:5: the level is 'two'"),
                  HasSubstr("building.cfg:6: the name must stand in quotes"), HasSubstr("building.cfg:7: y is 'x'"),
                  HasSubstr("building.cfg:8: the rotation"), HasSubstr("building.cfg:9: a quote is not closed"),
                  HasSubstr("building.cfg:10: 'y' is one word too many"),
                  HasSubstr("building.cfg:11: expected 'level'")));
}

TEST_F(CheckBuilding, TwoUnits) {
  room("A", kSquare);
  config("units ft\nunits m\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("UNUSABLE building.cfg:2: another line says the other unit")));
}

TEST_F(CheckBuilding, UnusableFindingsComeFirst) {
  room("A", std::string(kSquare));
  room("B", "4 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 3 3 3 3\n");
  config("A 10 5 A 10 5\n");
  const auto all = findings();
  ASSERT_GE(all.size(), 2U);
  EXPECT_THAT(all.front(), HasSubstr("UNUSABLE room-B.room"));
  EXPECT_THAT(all[1], HasSubstr("building.cfg:1"));
}

// --- Walls
// -------------------------------------------------------------------------------------------------------------

TEST_F(CheckBuilding, WallsWithoutLength) {
  room("A", "5 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n1 3 3 3 3\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-A.room:6: a wall without length at (3, 3)")));
}

TEST_F(CheckBuilding, DuplicateWalls) {
  room("A", "5 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n1 10 0 0 0\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-A.room:6: the wall is the same as on line 2")));
}

TEST_F(CheckBuilding, WallsDrawnOverEachOther) {
  room("A", "5 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n1 4 0 7 0\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-A.room:6: the wall runs over the wall on line 2 for 3 ft")));
}

TEST_F(CheckBuilding, EndsThatAlmostMeet) {
  room("A", "4 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0.1\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(AllOf(HasSubstr("room-A.room:"), HasSubstr("0.1 ft from another wall"))));
}

TEST_F(CheckBuilding, WallsOutsideTheFloor) {
  room("A", "5 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n1 12 0 12 3\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-A.room:6: the wall stands outside the floor")));
}

TEST_F(CheckBuilding, APartitionThatCutsTheFloorInTwo) {
  room("A", "5 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n1 4 0 4 10\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-A.room:1: walls cut 40 square ft off from the floor")));
}

TEST_F(CheckBuilding, ScreensAndColumnsAreFine) {
  room("A",
       "10 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n1 5 0 5 3\n1 2 7 4 7\n1 7 7 8 7\n1 8 7 8 8\n"
       "1 8 8 7 8\n1 7 8 7 7\n");
  config("");
  EXPECT_THAT(findings(), IsEmpty());
}

// --- Corners and edges
// -------------------------------------------------------------------------------------------------

constexpr std::string_view kEllWalls = "1 0 0 10 0\n1 10 0 10 5\n1 10 5 5 5\n1 5 5 5 10\n1 5 10 0 10\n1 0 10 0 0\n";

TEST_F(CheckBuilding, ACornerThatIsAnEdge) {
  room("A", "6 6 0\n" + std::string(kEllWalls) + "2 0 0\n2 10 0\n2 10 5\n2 5 5\n2 5 10\n2 0 10\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-A.room:11: the corner at (5, 5) is an edge")));
}

TEST_F(CheckBuilding, AnEdgeThatIsACorner) {
  room("A", "6 4 2\n" + std::string(kEllWalls) + "2 0 0\n2 10 0\n2 10 5\n2 5 10\n3 0 10\n3 5 5\n");
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-A.room:12: the edge at (0, 10) is a corner")));
}

TEST_F(CheckBuilding, MissingCornersAndEdges) {
  room("A", "6 4 1\n" + std::string(kEllWalls) + "2 0 0\n2 10 0\n2 10 5\n2 5 10\n3 5 2\n");
  config("");
  EXPECT_THAT(findings(),
              testing::UnorderedElementsAre(HasSubstr("room-A.room:1: the corner at (0, 10) is missing"),
                                            HasSubstr("room-A.room:1: the edge at (5, 5) is missing"),
                                            HasSubstr("room-A.room:12: the edge at (5, 2) stands on no wall")));
}

TEST_F(CheckBuilding, ACornerBesideWhereItBelongs) {
  room("A", "4 4 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n2 0 0\n2 10 0.5\n2 10 10\n2 0 10\n");
  config("");
  EXPECT_THAT(findings(), Contains(AllOf(HasSubstr("room-A.room:7: the corner at (10, 0.5)"),
                                         HasSubstr("the nearest is at (10, 0)"))));
}

TEST_F(CheckBuilding, CornersThatAreNoRightAnglesAreFine) {
  room("A", "3 3 0\n1 0 0 20 0\n1 20 0 10 15\n1 10 15 0 0\n2 0 0\n2 20 0\n2 10 15\n");
  config("");
  EXPECT_THAT(findings(), IsEmpty());
}

// --- Doors
// -------------------------------------------------------------------------------------------------------------

TEST_F(CheckBuilding, ADoorOffTheWall) {
  two_rooms();
  config("A 10.5 5 B 0 5\n");
  EXPECT_THAT(findings(),
              Contains(AllOf(HasSubstr("building.cfg:1: the door stands 0.5 ft off the nearest wall of room 'A'"),
                             HasSubstr("move it to (10, 5)"))));
}

TEST_F(CheckBuilding, ADoorInTheMiddleOfItsWallsThicknessIsFine) {
  two_rooms();
  config("A 10.25 5 B -0.25 5\nB -0.25 5 A 10.25 5\n");
  EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(CheckBuilding, DoorsListedOnceAreFine) {
  two_rooms();
  config("A 10 5 B 0 5\n");
  EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(CheckBuilding, AOneSidedDoorAmongOthers) {
  two_rooms();
  room("C", kSquare);
  config("A 10 5 B 0 5\nB 0 5 A 10 5\nC 5 0 B 5 10\n");
  EXPECT_THAT(findings(),
              ElementsAre(AllOf(HasSubstr("building.cfg:3: "), HasSubstr("is one-sided"), HasSubstr("from room 'B'"))));
}

TEST_F(CheckBuilding, LinesThatDisagreeAboutADoor) {
  two_rooms();
  config("A 10 5 B 0 5\nB 0 5.5 A 10 5\n");
  EXPECT_THAT(findings(), ElementsAre(AllOf(HasSubstr("building.cfg:1"), HasSubstr("differ by 0.5 ft"))));
}

TEST_F(CheckBuilding, DoorsOfAbsurdWidth) {
  two_rooms();
  config("door A 10 5 B 0 5 width 0.3\n");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("is 0.3 ft wide, and nobody is led through; write its clear width")));
  config("door A 10 5 B 0 5 width 40\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("is 40 ft wide; write its clear width")));
  config("door A 10 5 B 0 5 width -3\n");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("width is not positive")));
}

TEST_F(CheckBuilding, ADoorThatLeadsBackIntoItsRoom) {
  room("A", kSquare);
  config("A 10 5 A 0 5\n");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("building.cfg:1: a door leads from room 'A' to itself")));
}

TEST_F(CheckBuilding, ADoorBetweenLevels) {
  two_rooms();
  config("room A level 1\nA 10 5 B 0 5\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("joins levels 1 and 0")));
}

TEST_F(CheckBuilding, ADoorInWallsThatAreNotParallel) {
  two_rooms();
  config("A 10 5 B 5 0\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("stands in walls that are not parallel")));
}

TEST_F(CheckBuilding, TwoDoorsInOnePlace) {
  two_rooms();
  room("C", kSquare);
  config("A 10 5 B 0 5\nA 10 5.5 C 0 5\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("building.cfg:2: the door stands where the one on line 1 stands")));
}

// --- Levels
// ------------------------------------------------------------------------------------------------------------

TEST_F(CheckBuilding, ARoomThatNoDoorReaches) {
  two_rooms();
  room("C", kSquare);
  EXPECT_THAT(findings(), ElementsAre(AllOf(HasSubstr("room-C.room:1: no door"), HasSubstr("reaches room 'C'"))));
}

TEST_F(CheckBuilding, ARoomThatOnlyStairsReachHasNoPlaceOnItsLevel) {
  two_rooms();
  room("C", kSquare);
  room("D", kSquare);
  config("A 10 5 B 0 5\nroom D level 1\nstairs A 5 5 D 5 5\nstairs D 2 2 C 2 2\n");
  EXPECT_THAT(findings(), ElementsAre(AllOf(HasSubstr("room-C.room:1"), HasSubstr("add a 'frame' line"))));
  config("A 10 5 B 0 5\nroom D level 1\nstairs A 5 5 D 5 5\nstairs D 2 2 C 2 2\nframe A 0 0 0\nframe C 50 0 0\n");
  EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(CheckBuilding, StairsAndElevatorsWithinOneLevel) {
  two_rooms();
  config("A 10 5 B 0 5\nroom A level 1\nroom B level 1\nstairs A 5 5 B 5 5\nelevator A 2 2 A 8 8\n");
  EXPECT_THAT(findings(),
              ElementsAre(HasSubstr("building.cfg:4: the stairs join rooms 'A' and 'B', both on level 1; correct"),
                          HasSubstr("building.cfg:5: the elevator joins rooms 'A' and 'A', both on level 1")));
}

TEST_F(CheckBuilding, RoomsThatOverlap) {
  two_rooms();
  config("A 9 5 B 0 5\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("room-B.room:1: room 'B' overlaps room 'A' on level 0")));
}

TEST_F(CheckBuilding, RoomsThatCoincide) {
  two_rooms();
  config("frame A 0 0 0\nframe B 0 0 0\nA 10 5 B 0 5\n");
  EXPECT_THAT(findings(), testing::IsSupersetOf({HasSubstr("overlaps room 'A'"), HasSubstr("10 ft apart")}));
}

TEST_F(CheckBuilding, ALoopOfDoorsThatDoesNotClose) {
  two_rooms();
  room("C", "4 0 0\n1 0 0 20 0\n1 20 0 20 5\n1 20 5 0 5\n1 0 5 0 0\n");
  config("A 10 5 B 0 5\nA 5 10 C 5 0\nB 5 10 C 17 0\n");
  EXPECT_THAT(findings(), Contains(AllOf(HasSubstr("building.cfg:3"), HasSubstr("2 ft apart"))));
  const Result<Building> building = load_building(dir_.path());
  ASSERT_TRUE(building.ok());
  ASSERT_EQ(building->loop_closures.size(), 1U);
  EXPECT_NEAR(building->loop_closures[0].error, feet(2.0), 1e-9);
}

// --- Sizes, names, places
// ----------------------------------------------------------------------------------------------

TEST_F(CheckBuilding, AbsurdUnits) {
  room("A", "4 0 0\n1 0 0 3 0\n1 3 0 3 3\n1 3 3 0 3\n1 0 3 0 0\n");
  config("");
  EXPECT_THAT(findings(), Contains(HasSubstr("building.cfg: the largest room has only 9 square ft")));
  room("A", "4 0 0\n1 0 0 3000 0\n1 3000 0 3000 3000\n1 3000 3000 0 3000\n1 0 3000 0 0\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("room-A.room:1: the room is absurdly large, 3000 ft by 3000 ft")));
  room("A", "4 0 0\n1 0 0 0.5 0\n1 0.5 0 0.5 9\n1 0.5 9 0 9\n1 0 9 0 0\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("room-A.room:1: the room is absurdly small, 0.5 ft by 9 ft")));
  room("A", "4 0 0\n1 0 0 228 0\n1 228 0 228 264\n1 228 264 0 264\n1 0 264 0 0\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("building.cfg: every room is more than 196.85 ft wide")));
}

TEST_F(CheckBuilding, LinesAboutRoomsWithoutAFileAreLeftOut) {
  room("A", kSquare);
  config("room B level 0 \"B\"\nplace B 1 1 \"x\"\nexit B 1 1\nstairs A 1 1 B 1 1\nframe B 0 0 0\n");
  EXPECT_EQ(findings().size(), 5U);
  const Result<Building> building = load_building(dir_.path());
  ASSERT_TRUE(building.ok());
  EXPECT_TRUE(building->places.empty() && building->exits.empty() && building->links.empty());
}

TEST_F(CheckBuilding, PlacesOutsideTheirRoom) {
  room("A", kSquare);
  config("place A 15 5 \"Lectern\"\nexit A 10 5\nexit A 5 -3\n");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("building.cfg:1: the place at (15, 5) lies outside"),
                                      HasSubstr("building.cfg:3: the exit at (5, -3) lies outside")));
}

TEST_F(CheckBuilding, NamesThatCannotBeToldApart) {
  room("A", kSquare);
  config("place A 5 5 \"Desk\"\nplace A 6 6 \"Desk\"\nplace A 7 7 \"\"\nname \"one\"\nname \"two\"\n");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("building.cfg:2: another place is called \"Desk\""),
                                      HasSubstr("building.cfg:3: the place has an empty name"),
                                      HasSubstr("building.cfg:5: the building has a name already")));
}

TEST_F(CheckBuilding, ARoomThatIsCalledLikeAKeyword) {
  room("exit", kSquare);
  config("");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("room-exit.room: the room's id is a keyword")));
}

TEST_F(CheckBuilding, AMissingConfigurationIsAWarning) {
  room("A", kSquare);
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("building.cfg: is missing")));
}

}  // namespace
}  // namespace echoway
