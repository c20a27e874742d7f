// What the guide doubts reaches the locator: a wearer said where they stand, and meant the other one of two places that
// look the same. Led from there they get nowhere.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <set>

#include "echoway/session.hpp"
#include "echoway/sim/simulate.hpp"
#include "tracker/likely.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"

namespace echoway {
namespace {

using test::kFarCorner;

constexpr Vec2 kHere{2.0, 1.0};
constexpr double kLed = 25.0;  ///< s; the way has been told for a while, and not for long enough to doubt the place.

/// Turns round once, which tells which way they face, and then stands still whatever they are told.
Result<sim::Simulation> stand_still(const Building& hall, std::uint64_t seed) {
  sim::Walk walk;
  walk.seed = seed;
  walk.start = {"hall", kHere};
  walk.world = sim::make_world(sim::Profile::empty);
  for (int quarter = 0; quarter < 4; ++quarter) walk.add(sim::TurnBy{degrees(90.0)});
  walk.add(sim::Pause{100.0});
  return sim::simulate(hall, walk);
}

struct Outcome {
  std::set<CueKind> cues;         ///< Told after kLed,
  bool searching_at_last = false;
  bool thought_of_here = false;   ///< whether where they are was ever likely by then,
  bool thinks_of_here = false;    ///< and whether it is in the end.
};

/// Led to where they would have to walk from the place that they said; `heading` is what they said of it.
std::optional<Outcome> lead_from_the_wrong_place(std::optional<double> heading, std::uint64_t seed = 1) {
  const Building hall = test::plain_hall();
  const Result<sim::Simulation> walk = stand_still(hall, seed);
  SessionConfig config;
  config.start = {0, kFarCorner - kHere, heading};
  const auto session = Session::open(hall, config);
  if (!walk || !session || !(*session)->set_destination({Goal::Kind::spot, -1, {0, {1.0, 2.0}}})) return std::nullopt;
  Outcome outcome;
  test::play(*walk, **session, [&](std::size_t i) {
    const bool led = walk->scans.firings[i].time_s > kLed;
    if (!led && test::is_likely((*session)->hypotheses(), kHere)) outcome.thought_of_here = true;
    for (Cue cue; (*session)->next_cue(cue);) {
      if (led) outcome.cues.insert(cue.kind);
    }
  });
  outcome.searching_at_last = (*session)->estimate().state == TrackState::searching;
  outcome.thinks_of_here = test::is_likely((*session)->hypotheses(), kHere);
  return outcome;
}

TEST(SessionDoubt, WhoIsLedAndComesNoNearerIsLookedForElsewhere) {
  const auto outcome = lead_from_the_wrong_place(std::nullopt);
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->thought_of_here) << "the test would say nothing";
  EXPECT_TRUE(outcome->searching_at_last);
  EXPECT_TRUE(outcome->thinks_of_here);
  EXPECT_TRUE(outcome->cues.contains(CueKind::uncertain)) << "the wearer is told";
}

TEST(SessionDoubt, WhoDidNotSayWhichWayTheyFaceIsLookedForElsewhereThoughTheFirstEchoSeemedToTell) {
  constexpr std::uint64_t kFirstEchoTells = 4;
  const auto outcome = lead_from_the_wrong_place(std::nullopt, kFirstEchoTells);
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->thinks_of_here);
  EXPECT_TRUE(outcome->cues.contains(CueKind::uncertain)) << "the wearer is told";
}

TEST(SessionDoubt, WhoSaidForSureWhereTheyAreIsBelieved) {
  const auto outcome = lead_from_the_wrong_place(kPi);
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->searching_at_last);
  EXPECT_FALSE(outcome->thinks_of_here);
  EXPECT_FALSE(outcome->cues.contains(CueKind::uncertain));
}

}  // namespace
}  // namespace echoway
