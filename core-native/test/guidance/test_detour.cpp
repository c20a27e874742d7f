#include "guidance/detour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "echoway/routing/router.hpp"
#include "guidance/hindrances.hpp"
#include "support/plans.hpp"

namespace echoway::guidance {
namespace {

double length(const std::vector<Vec2>& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += distance(way[i - 1], way[i]);
  return sum;
}

double nearest(const std::vector<Vec2>& way, const std::vector<Vec2>& things) {
  double best = 1e9;
  for (std::size_t i = 1; i < way.size(); ++i) {
    for (const Vec2 p : things) best = std::min(best, distance(Segment{way[i - 1], way[i]}, p));
  }
  return best;
}

std::vector<ThingPoint> heard(const std::vector<Vec2>& things) {
  std::vector<ThingPoint> points;
  for (const Vec2 at : things) points.push_back({at});
  return points;
}

class DetourTest : public ::testing::Test {
 protected:
  Building hall = test::make_grid(1, 1, 6.0);
  Router router{hall};
  const FreeSpace& space = router.space(0);
  Detour detour;
  std::vector<Vec2> way;
};

TEST_F(DetourTest, GoesStraightWhereNothingStands) {
  ASSERT_TRUE(detour.find(space, 0, {}, {1, 3}, {4.5, 3.4}, way));
  EXPECT_EQ(way.size(), 2U);
}

TEST_F(DetourTest, KeepsClearOfAThingByASmallDetour) {
  const std::vector<Vec2> things{{2.8, 3.0}};
  ASSERT_TRUE(detour.find(space, 0, heard(things), {1, 3}, {4.5, 3}, way));
  EXPECT_GT(nearest(way, things), 0.45);
  EXPECT_LT(length(way), 4.2);
}

TEST_F(DetourTest, TakesTheWideGapAndNotTheNarrowOne) {
  std::vector<Vec2> things;  // a row with a gap of 0.5 m ahead and one of 1.6 m to the left
  for (double y = 0.2; y < 5.9; y += 0.1) {
    const bool narrow = std::abs(y - 3.0) < 0.25;
    const bool wide = std::abs(y - 4.8) < 0.8;
    if (!narrow && !wide) things.push_back({2.8, y});
  }
  ASSERT_TRUE(detour.find(space, 0, heard(things), {1, 3}, {4.5, 3}, way));
  EXPECT_GT(nearest(way, things), 0.5);
}

TEST_F(DetourTest, FeelsItsWayThroughWhatIsOnlyHeardAndNeverThroughAWall) {
  std::vector<Vec2> things;
  for (double y = 0.1; y < 6.0; y += 0.1) things.push_back({2.8, y});
  EXPECT_TRUE(detour.find(space, 0, heard(things), {1, 3}, {4.5, 3}, way)) << "echoes may err";
  hall.rooms[0].walls.push_back({{2.8, 0.0}, {2.8, 6.0}});
  const Router walled(hall);
  Detour other;
  EXPECT_FALSE(other.find(walled.space(0), 0, {}, {1, 3}, {4.5, 3}, way));
}

TEST_F(DetourTest, IsKeptWhileAnotherWayIsHardlyBetter) {
  const GuideConfig config;
  Hindrances hindrances(config);
  hindrances.hear(0, {2.8, 3.02}, 0.0);
  const auto side = [&](Vec2 from, double now) {
    std::vector<LinePoint> line{{from, WaypointKind::start, -1}, {{4.5, 3.0}, WaypointKind::goal, -1}};
    hindrances.bend(space, 0, now, line);
    return line.size() < 3 ? 0.0 : line[1].at.y - 3.0;
  };
  const double first = side({1.0, 3.0}, 0.0);
  ASSERT_NE(first, 0.0);
  // The wearer drifts a little to the other side, where a way round would be a little shorter.
  const double across = first > 0.0 ? -0.12 : 0.12;
  EXPECT_GT(side({1.2, 3.0 + across}, 1.0) * first, 0.0);
}

TEST_F(DetourTest, WhoIsStoppedAgainAndAgainAtOnePlaceIsLedPastItElsewhere) {
  const GuideConfig config;
  Hindrances hindrances(config);
  for (double y = 0.2; y < 5.9; y += 0.1) hindrances.hear(0, {2.8, y}, 0.0);  // all across, as far as is known
  const Pose2 before{{2.4, 3.0}, 0.0};
  // How far beside the place where they were stopped the way leads on.
  const auto beside = [&] {
    std::vector<LinePoint> line{{before.position, WaypointKind::start, -1}, {{4.5, 3.0}, WaypointKind::goal, -1}};
    hindrances.bend(space, 0, 1.0, line);
    double most = 0.0;
    for (const LinePoint& p : line) most = std::max(most, std::abs(p.at.y - before.position.y));
    return most;
  };
  hindrances.touch(0, before, 0.35, 1.0);
  EXPECT_LT(beside(), 0.3) << "by touch, where a gap may be";
  for (int again = 0; again < 20; ++again) hindrances.stand_before(0, before, 0.35, 1.0);
  EXPECT_LT(beside(), 0.3) << "who stands and hears it has not been stopped again";
  for (int again = 0; again < 3; ++again) hindrances.touch(0, before, 0.35, 1.0);
  EXPECT_GT(beside(), 0.3);
}

TEST_F(DetourTest, WhoIsStoppedAgainAndAgainIsLedThroughTheGapBetweenThatAndTheWall) {
  const GuideConfig config;
  Hindrances hindrances(config);
  const Pose2 before{{2.4, 5.36}, 0.0};  // the wall is at 6 m
  std::vector<Vec2> things{{2.75, 5.36}};
  for (double y = 0.1; y < 5.1; y += 0.13) things.push_back({2.75, y});  // heard, all across to the other wall
  for (const Vec2 at : things) hindrances.hear(0, at, 0.0);
  for (int again = 0; again < 12; ++again) hindrances.touch(0, before, 0.35, 1.0);
  std::vector<LinePoint> line{{before.position, WaypointKind::start, -1}, {{4.5, 5.0}, WaypointKind::goal, -1}};
  hindrances.bend(space, 0, 1.0, line);
  std::vector<Vec2> led;
  for (const LinePoint& p : line) led.push_back(p.at);
  EXPECT_GT(nearest(led, things), 0.2);
}

TEST_F(DetourTest, LeadsRoundAThingInWhichACornerOfTheWayLies) {
  const GuideConfig config;
  Hindrances hindrances(config);
  std::vector<Vec2> thing;  // two metres broad, with more room to its left than to its right
  for (double x = 2.0; x < 4.0; x += 0.15) thing.push_back({x, 2.0});
  for (const Vec2 at : thing) hindrances.hear(0, at, 0.0);
  std::vector<LinePoint> line{{{2.6, 1.2}, WaypointKind::start, -1},
                              {{2.8, 2.0}, WaypointKind::turn, -1},
                              {{2.4, 5.5}, WaypointKind::goal, -1}};
  hindrances.bend(space, 0, 0.0, line);
  std::vector<Vec2> led;
  for (const LinePoint& p : line) led.push_back(p.at);
  EXPECT_GT(nearest(led, thing), 0.4);
  EXPECT_LT(length(led), 6.0);
  EXPECT_EQ(line.back().kind, WaypointKind::goal);
}

}  // namespace
}  // namespace echoway::guidance
