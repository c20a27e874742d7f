#include "tracker/between_levels.hpp"

#include <gtest/gtest.h>

#include <string>

#include "echoway/building/loader.hpp"
#include "echoway/sim/simulate.hpp"
#include "tracker/play.hpp"

namespace echoway::tracker {
namespace {

constexpr double kEchoShare = 0.5;

Shot echo_from(double range) {
  Shot shot;
  shot.echo = true;
  shot.range = range;
  return shot;
}

/// Of all readings, by the midpoint rule.
template <typename Density>
double total(const Density& density) {
  constexpr double kStep = 0.001;
  double sum = density(Shot{});
  for (double range = 0.5 * kStep; range < 12.0; range += kStep) sum += kStep * density(echo_from(range));
  return sum;
}

TEST(BetweenLevels, ReadingsAreAsLikelyAsProbabilitiesMustBe) {
  EXPECT_NEAR(total(in_cabin), 1.0, 1e-6);
  EXPECT_NEAR(total([](const Shot& shot) { return on_stairs(shot, kEchoShare); }), 1.0, 1e-6);
}

TEST(BetweenLevels, ACabinIsHeardByItsNearWalls) {
  EXPECT_GT(in_cabin(echo_from(0.6)), 3.0 * in_cabin(echo_from(2.5)));
  EXPECT_GT(in_cabin(echo_from(2.5)), 10.0 * in_cabin(echo_from(6.0)));
}

TEST(BetweenLevels, StairsAreHeardByWhatStandsBesideAFlight) {
  EXPECT_GT(on_stairs(echo_from(0.6), kEchoShare), 3.0 * on_stairs(echo_from(3.5), kEchoShare));
  EXPECT_GT(on_stairs(echo_from(3.5), kEchoShare), 5.0 * on_stairs(echo_from(6.0), kEchoShare));
}

TEST(BetweenLevels, ABeltThatHearsLittleHearsAsLittleOnStairs) {
  EXPECT_DOUBLE_EQ(on_stairs(Shot{}, 0.2), 0.8);
  EXPECT_NEAR(on_stairs(echo_from(1.0), 0.2) / on_stairs(echo_from(1.0), 0.6), 1.0 / 3.0, 1e-12);
}

// Nobody says that they take stairs, and two flights lead to rooms that look much like the one below. Where being on
// stairs explains whatever is heard, one in seven is taken to climb on, these two among them.
TEST(BetweenLevels, WhoHasTakenStairsIsFoundWhereTheyLead) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/westport-house");
  for (const std::uint64_t seed : {8, 12}) {
    sim::Walk walk;
    walk.seed = seed;
    walk.start = {"g-vestibule", {4.2, 4.2}};
    walk.world = sim::make_world(sim::Profile::furnished);
    walk.add(sim::GoTo{{"1-stairs-2", {2.2, 2.4}}});
    walk.add(sim::GoTo{{"2-stairwell", {1.9, 4.2}}});
    walk.add(sim::GoTo{{"2-main-corridor", {9.7, 2.1}}});
    EXPECT_EQ(test::room_at_the_end(building, walk), building.find_room("2-main-corridor")) << "climb " << seed;
  }
}

}  // namespace
}  // namespace echoway::tracker
