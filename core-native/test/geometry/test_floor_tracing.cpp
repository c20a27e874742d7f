#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "echoway/geometry/inclusion.hpp"
#include "echoway/geometry/pose2.hpp"
#include "echoway/random.hpp"
#include "geometry/floor_tracing.hpp"

namespace echoway {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

std::vector<Segment> outline(const std::vector<Vec2>& points) {
  std::vector<Segment> walls;
  for (std::size_t i = 0; i < points.size(); ++i) walls.push_back({points[i], points[(i + 1) % points.size()]});
  return walls;
}

std::vector<Segment> operator+(std::vector<Segment> a, const std::vector<Segment>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::vector<Segment> kRoom = outline({{0, 0}, {10, 0}, {10, 8}, {0, 8}});

double area(const FloorTrace& floor) {
  double sum = 0.0;
  for (const auto& loop : floor.boundary) sum += signed_area(loop);
  return sum;
}

double total_turn(const FloorTrace& floor) {
  return std::accumulate(floor.meetings.begin(), floor.meetings.end(), 0.0,
                         [](double sum, const WallMeeting& m) { return sum + kPi - m.angle; });
}

TEST(TraceFloor, FollowsTheOutlineCounterClockwise) {
  const FloorTrace floor = trace_floor(kRoom);
  ASSERT_TRUE(floor.closed);
  ASSERT_THAT(floor.boundary, SizeIs(1));
  EXPECT_THAT(floor.boundary[0], SizeIs(4));
  EXPECT_DOUBLE_EQ(signed_area(floor.boundary[0]), 80.0);
  EXPECT_THAT(floor.meetings, SizeIs(4));
  EXPECT_THAT(floor.free_ends, IsEmpty());
}

TEST(TraceFloor, DoesNotCareHowWallsAreOrderedOrDirected) {
  Random random(11);
  const std::vector<Segment> ell = outline({{0, 0}, {10, 0}, {10, 4}, {5, 4}, {5, 8}, {0, 8}});
  const double expected = area(trace_floor(ell));
  for (int i = 0; i < 50; ++i) {
    std::vector<Segment> mixed = ell;
    for (std::size_t k = mixed.size(); k > 1; --k) std::swap(mixed[k - 1], mixed[random.next() % k]);
    for (Segment& wall : mixed) {
      if (random.uniform() < 0.5) std::swap(wall.a, wall.b);
    }
    const FloorTrace floor = trace_floor(mixed);
    ASSERT_TRUE(floor.closed);
    EXPECT_NEAR(area(floor), expected, 1e-12);
    EXPECT_NEAR(total_turn(floor), kTwoPi, 1e-9);
  }
}

TEST(TraceFloor, TurnsAndMovesWithTheRoom) {
  const std::vector<Segment> room =
      outline({{0, 0}, {10, 0}, {12, 7}, {5, 4}, {0, 8}}) + std::vector<Segment>{{{3, 0}, {3, 2}}};
  for (const Pose2 move : {Pose2{{3, -7}, 0.4}, Pose2{{1e6, 1e6}, 2.0}, Pose2{{-5e5, 10}, -1.1}}) {
    std::vector<Segment> moved;
    for (const Segment& wall : room) moved.push_back({move.transform(wall.a), move.transform(wall.b)});
    const FloorTrace there = trace_floor(moved);
    ASSERT_TRUE(there.closed);
    EXPECT_NEAR(area(there), area(trace_floor(room)), 1e-6);
    EXPECT_THAT(there.meetings, SizeIs(trace_floor(room).meetings.size()));
  }
}

TEST(TraceFloor, WallsMayMeetAtAT) {
  // The right wall is drawn in one piece beyond which the floor goes on: an L of two overlapping strokes.
  const std::vector<Segment> walls{{{0, 0}, {10, 0}}, {{10, 0}, {10, 4}}, {{10, 4}, {5, 4}},
                                   {{5, 2}, {5, 8}},  {{5, 8}, {0, 8}},   {{0, 8}, {0, 0}}};
  const FloorTrace floor = trace_floor(walls);
  ASSERT_TRUE(floor.closed);
  EXPECT_NEAR(area(floor), 60.0, 1e-9);
  ASSERT_THAT(floor.free_ends, SizeIs(1));
  EXPECT_EQ(floor.free_ends[0].wall, 3U);
}

TEST(TraceFloor, ScreensReflectButDoNotBound) {
  const FloorTrace floor = trace_floor(kRoom + std::vector<Segment>{{{4, 0}, {4, 3}}, {{6, 5}, {8, 5}}});
  ASSERT_TRUE(floor.closed);
  EXPECT_THAT(floor.boundary, SizeIs(1));
  EXPECT_NEAR(area(floor), 80.0, 1e-9);
  EXPECT_THAT(floor.outside_walls, IsEmpty());
  const auto free_tips = std::count_if(floor.meetings.begin(), floor.meetings.end(),
                                       [](const WallMeeting& m) { return m.angle > kTwoPi - 1e-9; });
  EXPECT_EQ(free_tips, 3) << "the stub's end and both ends of the free-standing screen";
}

TEST(TraceFloor, ColumnsAreHolesAlsoWhenAScreenHoldsThem) {
  const std::vector<Segment> column = outline({{4, 3}, {6, 3}, {6, 5}, {4, 5}});
  const std::vector<Segment> screen{{{5, 0}, {5, 3}}};
  for (const auto& walls : {kRoom + column, kRoom + column + screen}) {
    const FloorTrace floor = trace_floor(walls);
    ASSERT_TRUE(floor.closed);
    ASSERT_THAT(floor.boundary, SizeIs(2));
    EXPECT_NEAR(signed_area(floor.boundary[1]), -4.0, 1e-9);
    EXPECT_EQ(classify(floor.boundary, {5, 4}), Inclusion::outside);
    EXPECT_EQ(classify(floor.boundary, {3, 4}), Inclusion::inside);
  }
}

TEST(TraceFloor, WhatStandsInsideAColumnIsNoFloor) {
  const FloorTrace floor =
      trace_floor(kRoom + outline({{3, 2}, {7, 2}, {7, 6}, {3, 6}}) + outline({{4, 3}, {6, 3}, {6, 5}, {4, 5}}));
  ASSERT_THAT(floor.boundary, SizeIs(2));
  EXPECT_EQ(classify(floor.boundary, {5, 4}), Inclusion::outside);
  EXPECT_EQ(classify(floor.boundary, {3.5, 4}), Inclusion::outside);
  EXPECT_THAT(floor.outside_walls, SizeIs(4));
}

TEST(TraceFloor, JoinsEndsThatNearlyMeet) {
  std::vector<Segment> walls = kRoom;
  walls[3].b = {0.02, 0.03};
  const FloorTrace floor = trace_floor(walls);
  ASSERT_TRUE(floor.closed);
  EXPECT_NEAR(area(floor), 80.0, 0.5);
  EXPECT_THAT(floor.snapped, testing::Not(IsEmpty()));
  EXPECT_THAT(floor.free_ends, IsEmpty());
}

TEST(TraceFloor, AGapIsNotClosed) {
  std::vector<Segment> walls = kRoom;
  walls[3].b = {0.0, 0.06};
  const FloorTrace floor = trace_floor(walls);
  EXPECT_FALSE(floor.closed);
  ASSERT_THAT(floor.free_ends, SizeIs(2));
  EXPECT_NEAR(gap_at(walls, floor.free_ends[0]), 0.06, 1e-12);
}

TEST(TraceFloor, AnOverlongWallClosesAllTheSame) {
  std::vector<Segment> walls = kRoom;
  walls[0].b = {11, 0};
  const FloorTrace floor = trace_floor(walls);
  ASSERT_TRUE(floor.closed);
  EXPECT_NEAR(area(floor), 80.0, 1e-9);
}

TEST(TraceFloor, NothingEnclosesNothing) {
  EXPECT_FALSE(trace_floor({}).closed);
  EXPECT_FALSE(trace_floor(std::vector<Segment>{{{0, 0}, {5, 0}}}).closed);
  EXPECT_FALSE(trace_floor(std::vector<Segment>{{{0, 0}, {5, 0}}, {{5, 0}, {5, 5}}}).closed);
  EXPECT_FALSE(trace_floor(outline({{0, 0}, {5, 0}, {5, 0.001}})).closed) << "a crack is no floor";
}

TEST(TraceFloor, TouchingWallsAndSliversHold) {
  EXPECT_TRUE(trace_floor(outline({{0, 0}, {200, 0}, {200, 0.1}, {0, 0.1}})).closed);
  // Two nearly coincident partitions, nearly parallel to a wall.
  const FloorTrace floor =
      trace_floor(kRoom + std::vector<Segment>{{{1, 1e-6}, {9, 2e-6}}, {{1, 4}, {9, 4 + 1e-9}}, {{1, 4}, {9, 4}}});
  ASSERT_TRUE(floor.closed);
  EXPECT_NEAR(area(floor), 80.0, 1e-3);
}

TEST(TraceFloor, AnyMessOfWallsIsSurvivedAndItsFloorHasTheAreaItClaims) {
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    std::vector<Segment> walls;
    const auto count = 1 + random.next() % 40;
    for (std::uint64_t i = 0; i < count; ++i) {
      // On a coarse grid, so that walls meet, cross, overlap and coincide all the time.
      const auto coordinate = [&] {
        const auto coarse = static_cast<double>(random.next() % 6);
        return coarse + 0.04 * static_cast<double>(random.next() % 2);
      };
      const Segment wall{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
      if (wall.length() > kSamePoint) walls.push_back(wall);
    }
    const FloorTrace floor = trace_floor(walls);
    if (!floor.closed) continue;
    EXPECT_GT(signed_area(floor.boundary[0]), 0.0);
    EXPECT_GT(area(floor), 0.0);
    for (const WallMeeting& meeting : floor.meetings) {
      EXPECT_GT(meeting.angle, 0.0);
      EXPECT_LE(meeting.angle, kTwoPi);
    }
  }
}

TEST(TraceFloor, ATangleIsGivenUp) {
  Random random(9);
  std::vector<Segment> walls;
  for (int i = 0; i < 5000; ++i) {
    walls.push_back(
        {{random.uniform(0, 100), random.uniform(0, 100)}, {random.uniform(0, 100), random.uniform(0, 100)}});
  }
  EXPECT_FALSE(trace_floor(walls).closed);
}

TEST(TraceFloor, ThousandsOfScreensAreNoProblem) {
  Random random(10);
  std::vector<Segment> walls = outline({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}});
  for (int i = 0; i < 4900; ++i) {
    const Vec2 at{random.uniform(1, 999), random.uniform(1, 999)};
    const Vec2 towards = unit_from_angle(random.uniform(0, kTwoPi));
    walls.push_back({at, at + random.uniform(0.1, 0.9) * towards});
  }
  const FloorTrace floor = trace_floor(walls);
  ASSERT_TRUE(floor.closed);
  EXPECT_NEAR(signed_area(floor.boundary[0]), 1e6, 1e-6);
}

}  // namespace
}  // namespace echoway
