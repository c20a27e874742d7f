#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "hash/compare.hpp"
#include "hash/tracks.hpp"

namespace echoway::tracks {
namespace {

TEST(Tracks, AreTheSameFromOneThreadAndFromMany) {
  const std::string one = hashes(run(1));
  EXPECT_EQ(one, hashes(run(3)));
}

TEST(Tracks, HoldSomethingToCompare) {
  for (const Track& track : run(2)) {
    EXPECT_GT(track.scans.size(), 200U) << track.name;
    EXPECT_GT(track.estimates.size(), 5U) << track.name;
  }
}

TEST(Tracks, ComparisonSeesAMillimetreAndAnotherRoom) {
  std::istringstream a("w,1,0,2,3,0.5\nw,2,0,2,3,0.5\n");
  std::istringstream b("w,1,0,2.001,3,0.5\nw,2,1,2,3,0.5\n");
  const Difference d = compare(a, b);
  EXPECT_TRUE(d.comparable);
  EXPECT_NEAR(d.position_m, 0.001, 1e-12);
  EXPECT_EQ(d.rooms, 1U);
}

}  // namespace
}  // namespace echoway::tracks
