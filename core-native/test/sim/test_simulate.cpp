#include "echoway/sim/simulate.hpp"

#include <gtest/gtest.h>

#include "echoway/sim/random_walk.hpp"
#include "sim/rooms.hpp"

namespace echoway::sim {
namespace {

TEST(Simulate, GivesTheSameBytesForTheSameSeed) {
  const Building building = three_rooms();
  RandomWalkOptions options;
  options.duration_s = 20.0;
  const Walk walk = random_walk(building, options, 5);
  const Result<Simulation> one = simulate(building, walk, 9);
  const Result<Simulation> two = simulate(building, walk, 9);
  const Result<Simulation> other = simulate(building, walk, 10);
  ASSERT_TRUE(one.ok() && two.ok() && other.ok());
  ASSERT_EQ(one->scans.firings.size(), two->scans.firings.size());
  for (std::size_t i = 0; i < one->scans.firings.size(); ++i) {
    EXPECT_EQ(one->scans.firings[i].range_m, two->scans.firings[i].range_m);
    EXPECT_EQ(one->truth[i].pose, two->truth[i].pose);
  }
  std::size_t differences = 0;
  for (std::size_t i = 0; i < std::min(one->scans.firings.size(), other->scans.firings.size()); ++i) {
    differences += one->scans.firings[i].range_m != other->scans.firings[i].range_m;
  }
  EXPECT_GT(differences, one->scans.firings.size() / 10);
}

TEST(Simulate, WalksThroughDoorsIntoEveryRoomNamed) {
  Walk walk;
  walk.start = {"hall", {1.0, 1.0}};
  walk.add(GoTo{{"office", {1.0, 1.0}}});
  walk.add(GoTo{{"store", {1.0, 1.0}}});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  std::vector<std::string> rooms;
  for (const TruthRow& row : run->truth) {
    if (rooms.empty() || rooms.back() != row.room) rooms.push_back(row.room);
  }
  EXPECT_EQ(rooms, (std::vector<std::string>{"hall", "office", "store"}));
  EXPECT_NEAR(distance(run->truth.back().pose.position, {1.0, 1.0}), 0.0, 0.1);
}

TEST(Simulate, SaysWhichRoomItDoesNotKnow) {
  Walk walk;
  walk.start = {"hall", {1.0, 1.0}};
  walk.add(GoTo{{"cellar", {1.0, 1.0}}});
  const Result<Simulation> run = simulate(three_rooms(), walk);
  ASSERT_FALSE(run.ok());
  EXPECT_NE(run.error().message.find("cellar"), std::string::npos);
}

}  // namespace
}  // namespace echoway::sim
