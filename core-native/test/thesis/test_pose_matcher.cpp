#include "thesis/pose_matcher.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/rooms.hpp"

namespace echoway::thesis {
namespace {

Scan scan_of(const std::vector<Reading>& readings, const std::vector<int>& silent = {}) {
  Scan scan;
  for (const Reading& r : readings) scan.kept[static_cast<std::size_t>(scan.kept_count++)] = r;
  for (const int s : silent) scan.mute[static_cast<std::size_t>(scan.mute_count++)] = s;
  return scan;
}

// What a belt without radius would read at `pose` in a bare 6 x 4 m room, by hand: walls along their perpendiculars,
// corners along the line to them, within 7.5 degrees of a sensor's direction.
struct BareRoom {
  BareRoom() {
    belt.radius_m = 0.0;
    parameters.least_matches = 4;
  }
  [[nodiscard]] PoseMatcher matcher() const {
    return {rooms::rectangle(6.0, 4.0), {}, belt, DetectionTable(belt, parameters.detection), parameters};
  }
  BeltConfig belt{};
  ThesisParameters parameters{};
};

TEST(PositionEchoes, ScoresByTheObjectiveAsPrinted) {
  // At (2, 1.5) heading 0: sensor 0 looks at the east wall, 4.0 m; sensor 15/... of a 4-sensor belt look at 90, 180 and
  // 270 degrees: north 2.5, west 2.0, south 1.5 m. Readings off by +0.1, -0.2, 0, +0.3, all walls:
  // (2*0.1 + 2*0.2 + 0 + 2*0.3) / (2*4) = 0.15.
  BareRoom room;
  room.belt.sensors = 4;
  const ThesisParameters printed = ThesisParameters::as_printed();
  const PoseMatcher matcher = room.matcher();
  PositionEchoes echoes(printed);
  echoes.simulate(matcher.model(), {2.0, 1.5}, Directions(0.0, 4));
  const Score score = echoes.score(scan_of({{0, 4.1}, {1, 2.3}, {2, 2.0}, {3, 1.8}}), 0, 1);
  EXPECT_EQ(score.matched, 4);
  EXPECT_NEAR(score.objective_m, 0.15, 1e-12);
}

TEST(PositionEchoes, WeighsWallsTwiceAsMuchAsCorners) {
  // At (3, 2) the corner (6, 4) is at atan2(2, 3) = 33.69 degrees, 3.6056 m. Two sensors half a turn apart: heading
  // 33.69 degrees puts both on corners; heading 0 both on walls (3 m). One wall off by 0.3 and, with the four-sensor
  // grid of directions below, one corner off by 0.6: (2*0.3 + 1*0.6) / (2 + 1) = 0.4.
  BareRoom room;
  const ThesisParameters printed = ThesisParameters::as_printed();
  const PoseMatcher matcher = room.matcher();
  const double corner = std::atan2(2.0, 3.0);
  PositionEchoes echoes(printed);
  const Directions directions(0.0, 1);
  echoes.simulate(matcher.model(), {3.0, 2.0}, directions);
  EXPECT_NEAR(echoes.score(scan_of({{0, 3.3}}), 0, 1).objective_m, 0.3, 1e-12);
  echoes.simulate(matcher.model(), {3.0, 2.0}, Directions(corner, 1));
  EXPECT_NEAR(echoes.score(scan_of({{0, std::hypot(3.0, 2.0) + 0.6}}), 0, 1).objective_m, 0.6, 1e-9);
  // Both in one belt: directions 0 and 33.69 degrees are 2 of a grid of 10.686... only approximately, so a grid of 32
  // steps of 11.25 degrees: step 3 is 33.75 degrees, within the beam of the corner.
  echoes.simulate(matcher.model(), {3.0, 2.0}, Directions(0.0, 32));
  const Score both = echoes.score(scan_of({{0, 3.3}, {3, std::hypot(3.0, 2.0) + 0.6}}), 0, 1);
  EXPECT_EQ(both.matched, 2);
  EXPECT_NEAR(both.objective_m, 0.4, 1e-9);
}

TEST(PositionEchoes, PricesReadingsWithoutACounterpart) {
  // Beyond (5.1): at (2, 1.5) a 45 degree look hears nothing. A reading there counts 0.3, silence along a wall 0.15, a
  // difference of 2 m no more than 0.4: (2*0.4 + 1*0.3 + 1*0.15) / (2 + 1 + 1) = 0.3125.
  BareRoom room;
  const PoseMatcher matcher = room.matcher();
  PositionEchoes echoes(room.parameters);
  echoes.simulate(matcher.model(), {2.0, 1.5}, Directions(0.0, 8));
  const Score score = echoes.score(scan_of({{0, 2.0}, {1, 3.0}}, {2, 7}), 0, 1);
  EXPECT_EQ(score.matched, 1);
  EXPECT_NEAR(score.objective_m, 0.3125, 1e-12);
}

// Sensors 0, 4, 8, 11 of 15 look to 0, 96, 192 and 264 degrees; at heading -3 degrees to within 15 degrees of all four
// walls of a room, each within half a beam... only of three. Readings by hand need the belt's own geometry, so the
// matcher's mechanics are tested on its own predictions; how well it finds a wearer is tested against the simulated
// world.
Scan predicted_scan(const PoseMatcher& matcher, const Pose2& pose) {
  ScanAssembler assembler(matcher.model().belt(), {});
  const int n = matcher.model().belt().sensors;
  for (int i = 0; i < 2 * n; ++i) {
    assembler.add({i * 0.0624, i % n, matcher.model().predict(pose, i % n).range_m});
  }
  return assembler.scan();
}

Bounds bounds_about(const Pose2& pose, const ThesisParameters& parameters) {
  Bounds bounds;
  bounds.centre = pose.position;
  bounds.radius = parameters.movement_m;
  bounds.heading = pose.heading;
  bounds.half_turn = parameters.rotation_rad;
  return bounds;
}

class SampleRoom : public testing::Test {
 protected:
  [[nodiscard]] PoseMatcher matcher(const Room& room) const {
    return {room, {}, belt_, DetectionTable(belt_), parameters_};
  }
  BeltConfig belt_{};
  ThesisParameters parameters_{};
  MatchWorkspace workspace_{belt_, parameters_};
};

TEST_F(SampleRoom, FindsThePoseFromAStartWithinTheBounds) {
  const PoseMatcher room = matcher(rooms::sample_room());
  const Pose2 truth{{3.6, 3.1}, degrees(40.0)};
  const Bounds bounds = bounds_about({truth.position + Vec2{0.4, -0.5}, truth.heading - degrees(9.0)}, parameters_);
  const Match match = room.match(predicted_scan(room, truth), bounds, workspace_);
  ASSERT_TRUE(match.found);
  EXPECT_LT(distance(match.pose.position, truth.position), 0.05);
  EXPECT_LT(std::abs(wrap_angle(match.pose.heading - truth.heading)), degrees(5.0));
  EXPECT_NEAR(match.quality, match.objective_m / room.model().greatest_range(), 1e-12);
}

TEST_F(SampleRoom, StaysWithinTheBounds) {
  const PoseMatcher room = matcher(rooms::sample_room());
  const Pose2 start{{2.5, 1.5}, 0.3};
  const Match match = room.match(predicted_scan(room, {{5.0, 6.0}, 2.0}), bounds_about(start, parameters_), workspace_);
  ASSERT_TRUE(match.found);
  EXPECT_LE(distance(match.pose.position, start.position), parameters_.movement_m + 1e-9);
  EXPECT_LE(std::abs(match.pose.heading - start.heading), parameters_.rotation_rad + 1e-9);
}

TEST_F(SampleRoom, DiscardsPosesWithFewerThanFourReadingsToCompare) {
  const PoseMatcher room = matcher(rooms::sample_room());
  const Pose2 truth{{3.6, 3.1}, degrees(40.0)};
  Scan scan = predicted_scan(room, truth);
  scan.kept_count = 3;
  EXPECT_FALSE(room.match(scan, bounds_about(truth, parameters_), workspace_).found);
}

TEST_F(SampleRoom, TurnsWithTheMap) {
  const Room here = rooms::sample_room();
  const Pose2 to{{1e4, -3e3}, degrees(71.0)};
  const PoseMatcher a = matcher(here);
  const PoseMatcher b = matcher(rooms::moved(here, to));
  const Pose2 truth{{3.6, 3.1}, degrees(40.0)};
  const Pose2 start{{3.9, 2.8}, degrees(47.123)};
  const Scan scan = predicted_scan(a, truth);
  const Match at_a = a.match(scan, bounds_about(start, parameters_), workspace_);
  const Match at_b = b.match(scan, bounds_about(to.compose(start), parameters_), workspace_);
  ASSERT_TRUE(at_a.found && at_b.found);
  const Pose2 expected = to.compose(at_a.pose);
  EXPECT_NEAR(at_b.pose.position.x, expected.position.x, 1e-6);
  EXPECT_NEAR(at_b.pose.position.y, expected.position.y, 1e-6);
  EXPECT_NEAR(wrap_angle(at_b.pose.heading - expected.heading), 0.0, 1e-6);
}

TEST_F(SampleRoom, FindsAnyPoseInASearchOfTheRoom) {
  const PoseMatcher room = matcher(rooms::sample_room());
  const Pose2 truth{{4.4, 5.2}, degrees(-130.0)};
  std::vector<Mode> modes;
  modes.reserve(8);
  const Scan scan = predicted_scan(room, truth);
  room.search(scan, {}, {parameters_.search_spacing_m, 4}, 0, modes, workspace_);
  ASSERT_FALSE(modes.empty());
  EXPECT_LE(modes.size(), 8U);
  room.refine(scan, {}, {parameters_.search_spacing_m, 4}, modes[0], workspace_);
  EXPECT_LT(distance(modes[0].pose.position, truth.position), 0.3);
  EXPECT_LT(std::abs(wrap_angle(modes[0].pose.heading - truth.heading)), degrees(8.0));
}

TEST_F(SampleRoom, FindsNothingInARoomWithoutWalls) {
  const PoseMatcher nothing = matcher(Room{});
  const PoseMatcher room = matcher(rooms::sample_room());
  const Match match = nothing.match(predicted_scan(room, {{3.6, 3.1}, 0.0}), bounds_about({}, parameters_), workspace_);
  EXPECT_FALSE(match.found);
}

TEST(OfferMode, KeepsTheBestAndNoTwoAlike) {
  std::vector<Mode> modes;
  modes.reserve(2);
  offer_mode({0, {{0.0, 0.0}, 0.0}, 0.5}, modes);
  offer_mode({0, {{0.3, 0.0}, 0.1}, 0.4}, modes);  // the same place, better
  ASSERT_EQ(modes.size(), 1U);
  EXPECT_DOUBLE_EQ(modes[0].objective_m, 0.4);
  offer_mode({1, {{0.0, 0.0}, 0.0}, 0.6}, modes);
  offer_mode({0, {{5.0, 0.0}, 0.0}, 0.3}, modes);  // pushes the worst out
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_DOUBLE_EQ(modes[0].objective_m, 0.3);
  EXPECT_DOUBLE_EQ(modes[1].objective_m, 0.4);
}

}  // namespace
}  // namespace echoway::thesis
