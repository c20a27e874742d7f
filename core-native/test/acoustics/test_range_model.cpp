#include "echoway/acoustics/range_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "echoway/random.hpp"
#include "support/rooms.hpp"

namespace echoway {
namespace {

BeltConfig belt_of(double radius, double beam_degrees = 15.0) {
  BeltConfig belt;
  belt.radius_m = radius;
  belt.beam_rad = degrees(beam_degrees);
  return belt;
}

class Scene {
 public:
  Scene(Room room, const BeltConfig& belt, std::vector<Opening> openings = {})
      : model_(room, openings, belt, DetectionTable(belt)) {}

  [[nodiscard]] PredictedEcho towards(Vec2 axis, double direction_degrees) const {
    return model_.predict_towards(axis, unit_from_angle(degrees(direction_degrees)));
  }
  [[nodiscard]] const RangeModel& model() const { return model_; }

 private:
  RangeModel model_;
};

void expect_echo(const PredictedEcho& echo, ElementKind kind, int index, double range) {
  EXPECT_EQ(echo.kind, kind);
  EXPECT_EQ(echo.index, index);
  EXPECT_NEAR(echo.range_m, range, 1e-9);
}

void expect_silence(const PredictedEcho& echo) {
  EXPECT_EQ(echo.kind, ElementKind::none) << "heard element " << echo.index << " at " << echo.range_m;
  EXPECT_EQ(echo.range_m, Firing::kNoEcho);
}

// The 6 x 4 m room of test_support: walls 0 south, 1 east, 2 north, 3 west; corners likewise counter-clockwise from
// (0, 0).

TEST(RangeModel, HearsAWallAlongItsPerpendicular) {
  const Scene scene(rooms::rectangle(6.0, 4.0), belt_of(0.0));
  expect_echo(scene.towards({2.0, 1.5}, 0.0), ElementKind::wall, 1, 4.0);
  expect_echo(scene.towards({2.0, 1.5}, 180.0), ElementKind::wall, 3, 2.0);
  // 7 degrees off the axis the range is still the perpendicular's, not the ray's.
  expect_echo(scene.towards({2.0, 1.5}, 7.0), ElementKind::wall, 1, 4.0);
  expect_echo(scene.towards({2.0, 1.5}, -7.0), ElementKind::wall, 1, 4.0);
}

TEST(RangeModel, HearsNothingFromAWallOutsideItsBeam) {
  const Scene scene(rooms::rectangle(6.0, 4.0), belt_of(0.0));
  expect_silence(scene.towards({2.0, 1.5}, 8.0));
  expect_silence(scene.towards({2.0, 1.5}, -8.0));
}

TEST(RangeModel, HearsACornerAlongTheLineToItsApex) {
  // From (2, 1) the corner (6, 4) is 5 m away at atan2(3, 4) = 36.87 degrees.
  const Scene scene(rooms::rectangle(6.0, 4.0), belt_of(0.0));
  expect_echo(scene.towards({2.0, 1.0}, 36.87), ElementKind::corner, 2, 5.0);
  expect_echo(scene.towards({2.0, 1.0}, 43.0), ElementKind::corner, 2, 5.0);
  expect_silence(scene.towards({2.0, 1.0}, 45.0));
}

TEST(RangeModel, MeasuresFromTheFace) {
  // The face is 0.15 m ahead. Along the perpendicular that much is missing; 7 degrees off, 0.15 cos 7 = 0.148882.
  const Scene scene(rooms::rectangle(6.0, 4.0), belt_of(0.15));
  expect_echo(scene.towards({2.0, 1.5}, 0.0), ElementKind::wall, 1, 3.85);
  expect_echo(scene.towards({2.0, 1.5}, 7.0), ElementKind::wall, 1, 4.0 - 0.15 * std::cos(degrees(7.0)));
  // The corner seen from the face at (2.15, 1): sqrt(3.85^2 + 3^2) = 4.880830; it is then 37.93 degrees off.
  const double off = to_degrees(std::atan2(3.0, 3.85));
  EXPECT_NEAR(off, 37.93, 0.01);
  expect_silence(scene.towards({2.0, 1.0}, 0.0 + 29.0));
  const Vec2 face = Vec2{2.0, 1.0} + 0.15 * unit_from_angle(degrees(33.0));
  expect_echo(scene.towards({2.0, 1.0}, 33.0), ElementKind::corner, 2, distance(face, {6.0, 4.0}));
}

TEST(RangeModel, TheNearestInTheBeamWins) {
  // At (5.5, 3.6) looking to 40 degrees with a 100 degree beam: east wall 0.5, north wall 0.4, corner sqrt(0.41) =
  // 0.640.
  const Scene scene(rooms::rectangle(6.0, 4.0), belt_of(0.0, 100.0));
  expect_echo(scene.towards({5.5, 3.6}, 45.0), ElementKind::wall, 2, 0.4);
  expect_echo(scene.towards({5.5, 3.6}, 0.0), ElementKind::wall, 1, 0.5);
}

TEST(RangeModel, PutsItsSensorsCounterClockwiseFromTheChest) {
  const Scene scene(rooms::rectangle(6.0, 4.0), belt_of(0.0));
  // 15 sensors 24 degrees apart: with the chest at 66 degrees, sensor 1 looks to 90 and sensor 8 to 258 degrees.
  const Pose2 pose{{2.0, 1.5}, degrees(66.0)};
  expect_echo(scene.model().predict(pose, 1), ElementKind::wall, 2, 2.5);
  expect_silence(scene.model().predict(pose, 8));
}

TEST(RangeModel, KeepsToTheBeltsRange) {
  const Scene scene(rooms::rectangle(30.0, 4.0), belt_of(0.0));
  expect_silence(scene.towards({2.0, 2.0}, 0.0));                                        // 28 m, beyond 10.67
  expect_echo(scene.towards({19.4, 2.0}, 0.0), ElementKind::wall, 1, 10.6);
  expect_silence(scene.towards({29.9, 2.0}, 0.0));                                       // 0.1 m, within 6 in
}

TEST(RangeModel, AWallHidesWhatIsBehindIt) {
  // The notched room of test_support: a pier from (2, 0) to (3, 1.5) stands out of the south wall.
  const Scene scene(rooms::with_pier(), belt_of(0.0));
  expect_echo(scene.towards({1.0, 1.0}, 0.0), ElementKind::wall, 1, 1.0);                // the pier's west side
  expect_silence(scene.towards({1.0, 1.0}, to_degrees(std::atan2(-1.0, 5.0))));          // corner (6, 0) behind it
  expect_echo(scene.towards({5.0, 1.0}, to_degrees(std::atan2(-1.0, 1.0))), ElementKind::corner, 3, std::sqrt(2.0));
}

TEST(RangeModel, HearsAnEdgeThatIsNearAndStraightAhead) {
  const Scene scene(rooms::with_pier(), belt_of(0.0));
  // The pier's top left edge (2, 1.5) from (1, 2.5): sqrt(2) away at -45 degrees.
  expect_echo(scene.towards({1.0, 2.5}, -45.0), ElementKind::edge, 0, std::sqrt(2.0));
  expect_silence(scene.towards({1.0, 2.5}, -51.0));  // within the beam for a wall, not for an edge
}

TEST(RangeModel, AnEdgeTooFarAwayIsSilent) {
  Room room = rooms::rectangle(20.0, 20.0);
  room.edges = {{10.0, 10.0}};
  const Scene scene(room, belt_of(0.0));
  expect_echo(scene.towards({8.0, 8.5}, to_degrees(std::atan2(1.5, 2.0))), ElementKind::edge, 0, 2.5);
  expect_silence(scene.towards({7.0, 6.0}, to_degrees(std::atan2(4.0, 3.0))));  // 5 m
}

TEST(RangeModel, OnlyARightAngleSendsSoundBack) {
  // A triangle with a right angle at (0, 0) and 45 degrees at (4, 0) and (0, 4); all three are listed as corners.
  const Scene scene(rooms::polygon({{0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}}), belt_of(0.0));
  expect_echo(scene.towards({1.0, 1.0}, 225.0), ElementKind::corner, 0, std::sqrt(2.0));
  expect_silence(scene.towards({1.0, 0.5}, to_degrees(std::atan2(-0.5, 3.0))));
}

TEST(RangeModel, AReflectorAnswersAtAnyIncidence) {
  Room room = rooms::rectangle(6.0, 4.0);
  room.reflectors = {{{3.0, 1.0}, {3.0, 3.0}}};
  const Scene scene(room, belt_of(0.0));
  expect_echo(scene.towards({1.0, 2.0}, 0.0), ElementKind::reflector, 0, 2.0);
  // Turned by 20 degrees its perpendicular is out of the beam; the nearest point in the beam is met at 12.5 degrees.
  expect_echo(scene.towards({1.0, 2.0}, 20.0), ElementKind::reflector, 0, 2.0 / std::cos(degrees(12.5)));
  // Its end is at 26.57 degrees: past 34.07 nothing of it is in the beam.
  expect_echo(scene.towards({1.0, 2.0}, 33.0), ElementKind::reflector, 0, 2.0 / std::cos(degrees(25.5)));
  EXPECT_NE(scene.towards({1.0, 2.0}, 34.1).kind, ElementKind::reflector);
}

TEST(RangeModel, AReflectorHidesTheWallBehindIt) {
  Room room = rooms::rectangle(6.0, 4.0);
  room.reflectors = {{{2.0, 1.9}, {2.0, 2.1}}};
  // 0.05 m away the element is too near to be measured, and still in the way.
  const Scene scene(room, belt_of(0.0));
  expect_silence(scene.towards({1.95, 2.0}, 0.0));
  expect_echo(scene.towards({1.95, 3.0}, 0.0), ElementKind::wall, 1, 4.05);
}

TEST(RangeModel, SeesTheVisiblePartOfAHalfHiddenReflector) {
  // A screen from the south wall up to y = 2 hides the lower half of a bench behind it.
  Room room = rooms::rectangle(6.0, 4.0);
  room.walls.push_back({{2.0, 0.0}, {2.0, 2.0}});
  room.reflectors = {{{4.0, 0.5}, {4.0, 3.5}}};
  const Scene scene(room, belt_of(0.0, 60.0));
  const PredictedEcho echo = scene.towards({1.0, 1.0}, 45.0);
  // The ray past the screen's tip meets the bench at (4, 4)... beyond its end: nothing of it is seen from there.
  EXPECT_NE(echo.kind, ElementKind::reflector);
  // From (1, 1.8) the tip is at atan2(0.2, 1); the bench is seen from y = 1.8 + 3 * 0.2 = 2.4 upwards.
  const PredictedEcho above = scene.towards({1.0, 1.8}, 38.0);
  EXPECT_EQ(above.kind, ElementKind::reflector);
  EXPECT_NEAR(above.range_m, std::hypot(3.0, 0.6), 1e-4);
}

TEST(RangeModel, AnOpenDoorIsSilentAndItsJambsAreEdges) {
  // A 1 m door in the middle of the east wall.
  const Scene scene(rooms::rectangle(6.0, 4.0), belt_of(0.0), {{{6.0, 2.0}, 1.0}});
  expect_silence(scene.towards({4.5, 2.0}, 0.0));
  expect_echo(scene.towards({4.5, 1.0}, 0.0), ElementKind::wall, 1, 1.5);
  // Jambs at (6, 1.5) and (6, 2.5) count on from the room's own edges, of which there are none.
  const double bearing = to_degrees(std::atan2(0.5, 1.5));
  expect_echo(scene.towards({4.5, 2.0}, -bearing), ElementKind::edge, 0, std::hypot(1.5, 0.5));
  expect_echo(scene.towards({4.5, 2.0}, bearing), ElementKind::edge, 1, std::hypot(1.5, 0.5));
}

TEST(RangeModel, KeepsTheJambsThatARoomLists) {
  Room room = rooms::rectangle(6.0, 4.0);
  room.edges = {{6.0, 1.5}, {6.0, 2.5}};
  const RangeModel model(room, std::vector<Opening>{{{6.02, 2.0}, 1.0}}, belt_of(0.0), DetectionTable(belt_of(0.0)));
  // Four walls, one of them now in two pieces, four corners, two edges.
  EXPECT_EQ(model.element_count(), 5U + 4U + 2U);
}

TEST(RangeModel, FindsTheDoorsOfARoomFromEitherSide) {
  Building building;
  building.rooms.resize(2);
  building.doors = {{0, {6.0, 2.0}, 1, {0.0, 1.0}, 0.9}};
  ASSERT_EQ(openings_of(building, 0).size(), 1U);
  EXPECT_EQ(openings_of(building, 0)[0].at, (Vec2{6.0, 2.0}));
  EXPECT_EQ(openings_of(building, 1)[0].at, (Vec2{0.0, 1.0}));
  EXPECT_DOUBLE_EQ(openings_of(building, 1)[0].width, 0.9);
}

TEST(RangeModel, KnowsTheGreatestRangeOfARoom) {
  const BeltConfig belt;
  EXPECT_NEAR(RangeModel(rooms::rectangle(3.0, 4.0), {}, belt, DetectionTable(belt)).greatest_range(), 5.0, 1e-12);
  EXPECT_NEAR(RangeModel(rooms::rectangle(30.0, 4.0), {}, belt, DetectionTable(belt)).greatest_range(), feet(35),
              1e-12);
}

// The sweep over a grid of directions is a faster way to the same answers.
struct SweepCase {
  Room room;
  std::vector<Opening> openings;
  BeltConfig belt;
};

std::vector<SweepCase> sweep_cases() {
  Room furnished = rooms::with_pier();
  furnished.reflectors = {{{4.0, 2.5}, {5.0, 2.5}}, {{5.0, 2.5}, {5.0, 3.0}}, {{1.0, 3.5}, {1.2, 3.3}}};
  BeltConfig wide = belt_of(0.15, 55.0);
  wide.min_range_m = 0.0;
  return {{rooms::sample_room(), {}, belt_of(0.15)},
          {rooms::sample_room(), {{{feet(19.0), feet(17.0)}, feet(4.0)}}, belt_of(0.0, 30.0)},
          {furnished, {}, belt_of(0.15)},
          {furnished, {}, wide},
          {furnished, {}, belt_of(0.3, 170.0)}};
}

TEST(RangeModelSweep, GivesTheSameAnswersAsOneRayAtATime) {
  Random random(1);
  int heard = 0;
  for (const SweepCase& c : sweep_cases()) {
    const RangeModel model(c.room, c.openings, c.belt, DetectionTable(c.belt));
    for (int trial = 0; trial < 150; ++trial) {
      const Vec2 axis{random.uniform(0.0, 6.0), random.uniform(0.0, 6.0)};
      const int count = 1 + static_cast<int>(random.uniform(0.0, 100.0));
      const Directions directions(random.uniform(-7.0, 7.0), count);
      std::vector<PredictedEcho> echoes(static_cast<std::size_t>(directions.count()));
      model.sweep(axis, directions, echoes);
      for (int k = 0; k < directions.count(); ++k) {
        const PredictedEcho expected = model.predict_towards(axis, directions.unit(k));
        const PredictedEcho& swept = echoes[static_cast<std::size_t>(k)];
        ASSERT_EQ(swept.kind, expected.kind) << axis.x << ' ' << axis.y << ' ' << k;
        ASSERT_EQ(swept.range_m, expected.range_m);
        heard += swept.kind != ElementKind::none;
      }
    }
  }
  EXPECT_GT(heard, 5000);
}

TEST(RangeModel, TurnsWithItsMap) {
  // The same room turned by 37 degrees and moved gives the same ranges to turned sensors.
  const Room room = rooms::sample_room();
  const Pose2 moved{{120.0, -45.0}, degrees(37.0)};
  const BeltConfig belt = belt_of(0.15);
  const RangeModel here(room, {}, belt, DetectionTable(belt));
  const RangeModel there(rooms::moved(room, moved), {}, belt, DetectionTable(belt));
  Random random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const Pose2 pose{{random.uniform(1.3, 5.7), random.uniform(0.1, 6.6)}, random.uniform(-kPi, kPi)};
    const Pose2 turned = moved.compose(pose);
    for (int sensor = 0; sensor < belt.sensors; ++sensor) {
      const PredictedEcho a = here.predict(pose, sensor);
      const PredictedEcho b = there.predict(turned, sensor);
      ASSERT_EQ(a.kind, b.kind);
      ASSERT_NEAR(a.range_m, b.range_m, 1e-9);
    }
  }
}

TEST(RangeModel, StandsDegenerateRoomsAndPlaces) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Room nothing;
  Room point;
  point.walls = {{{1.0, 1.0}, {1.0, 1.0}}, {{0.0, 0.0}, {1e-12, 0.0}}};
  point.corners = {{1.0, 1.0}};
  point.reflectors = {{{2.0, 2.0}, {2.0, 2.0}}};
  Room broken = rooms::rectangle(6.0, 4.0);
  broken.walls.push_back({{nan, 0.0}, {1.0, 1.0}});
  broken.edges = {{nan, nan}};
  broken.reflectors = {{{1.0, nan}, {1.0, 1.0}}};
  for (const Room& room : {nothing, point, broken}) {
    const Scene scene(room, belt_of(0.15, 60.0), {{{1.0, 1.0}, 0.9}, {{nan, 0.0}, nan}});
    const Directions directions(0.3, 40);
    std::vector<PredictedEcho> echoes(40);
    for (const Vec2 axis : {Vec2{0.0, 0.0}, Vec2{1.0, 1.0}, Vec2{2.0, 2.0}, Vec2{6.0, 4.0}, Vec2{1e6, -1e6}}) {
      scene.model().sweep(axis, directions, echoes);
      for (const PredictedEcho& echo : echoes) {
        EXPECT_TRUE(std::isfinite(echo.range_m));
        EXPECT_EQ(echo.kind == ElementKind::none, echo.range_m == Firing::kNoEcho);
      }
    }
  }
}

TEST(RangeModel, IsContinuousExceptWhereTheWinnerChanges) {
  const BeltConfig belt = belt_of(0.15);
  const RangeModel model(rooms::sample_room(), {}, belt, DetectionTable(belt));
  Random random(3);
  for (int trial = 0; trial < 3000; ++trial) {
    const Pose2 pose{{random.uniform(0.3, 5.5), random.uniform(0.3, 6.5)}, random.uniform(-kPi, kPi)};
    const Pose2 nudged{{pose.position.x + 1e-7, pose.position.y - 1e-7}, pose.heading + 1e-7};
    const PredictedEcho a = model.predict(pose, 0);
    const PredictedEcho b = model.predict(nudged, 0);
    if (a.kind == b.kind && a.index == b.index) {
      ASSERT_NEAR(a.range_m, b.range_m, 1e-6);
    }
  }
}

}  // namespace
}  // namespace echoway
