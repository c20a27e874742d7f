// The proof of guidance in short: blindfolded wearers who know nothing but the cues. The long one: docs/guidance.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/blind_walk.hpp"
#include "support/plans.hpp"

namespace echoway {
namespace {

using test::WalkOutcome;

struct Sum {
  int arrived = 0;
  int wrong = 0;
  int instructions = 0;
  double walked = 0.0;
  double shortest = 0.0;
  std::vector<WalkOutcome> outcomes;
};

Sum walk_many(const Building& building, int walks) {
  const Router router(building);
  Sum sum;
  for (int i = 0; i < walks; ++i) {
    const auto seed = static_cast<std::uint64_t>(500 + i);
    Random random(seed);
    const Spot start = test::random_spot(router, random);
    const Spot end = test::random_spot(router, random);
    test::NoisyTruth source(0.12, degrees(4.0), seed);
    sum.outcomes.push_back(test::walk_blindfolded(router, start, random.uniform(-kPi, kPi), {Goal::Kind::spot, 0, end},
                                                  source, {}, seed));
    const WalkOutcome& o = sum.outcomes.back();
    sum.arrived += o.arrived ? 1 : 0;
    sum.wrong += o.wrong_cues;
    sum.instructions += o.instructions;
    sum.walked += o.walked_m;
    sum.shortest += o.shortest_m;
  }
  return sum;
}

constexpr int kWalks = 40;
const Sum& office() {
  static const Sum sum = walk_many(test::make_office_floor(5), kWalks);
  return sum;
}

TEST(ClosedLoop, BlindfoldedWearersArriveByCuesAlone) { EXPECT_GE(office().arrived, kWalks - 1); }

TEST(ClosedLoop, TheyWalkLittleMoreThanTheShortestWay) { EXPECT_LE(office().walked, 1.25 * office().shortest); }

TEST(ClosedLoop, NoInstructionPointsAtAWall) { EXPECT_EQ(office().wrong, 0); }

/// The noisy truth, and boxes that no sensor sees.
class UnseenBoxes : public test::NoisyTruth {
 public:
  UnseenBoxes(std::uint64_t seed, Vec2 low, Vec2 high) : NoisyTruth(0.12, degrees(4.0), seed), low_(low), high_(high) {}
  std::vector<Segment> things(RoomIndex room) override {
    if (room != 0) return {};
    const Vec2 right{high_.x, low_.y};
    const Vec2 left{low_.x, high_.y};
    return {{low_, right}, {right, high_}, {high_, left}, {left, low_}};
  }

 private:
  Vec2 low_;
  Vec2 high_;
};

TEST(ClosedLoop, WhoMeetsAThingThatNobodySawIsLedRoundIt) {
  const Building hall = test::make_grid(1, 1, 8.0);
  const Router router(hall);
  int arrived = 0;
  int bumps = 0;
  constexpr int kAgain = 10;
  for (std::uint64_t seed = 0; seed < kAgain; ++seed) {
    UnseenBoxes source(seed, {3.5, 3.6}, {4.5, 4.4});
    const WalkOutcome o = test::walk_blindfolded(router, {0, {1.0, 4.0}}, 0.0, {Goal::Kind::spot, 0, {0, {7.0, 4.0}}},
                                                 source, {}, seed);
    arrived += o.arrived ? 1 : 0;
    bumps += o.bumps;
  }
  EXPECT_GT(bumps, 0);
  EXPECT_GE(arrived, kAgain - 1);
}

/// A place that is off by so much all along, in the room's frame, though it is taken for well known.
class PlaceAside : public test::NoisyTruth {
 public:
  PlaceAside(std::uint64_t seed, Vec2 off) : NoisyTruth(0.08, degrees(4.0), seed), off_(off) {}
  void observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) override {
    NoisyTruth::observe(time_s, room, {pose.position + off_, pose.heading}, speed, guide);
  }

 private:
  Vec2 off_;
};

TEST(ClosedLoop, WhoIsTakenToBeBesideWhereTheyStandFindsTheDoorAllTheSame) {
  const Building rooms = test::make_grid(2, 1, 4.0);
  const Router router(rooms);
  constexpr int kAgain = 10;
  for (const double off : {-0.6, -0.4, 0.4, 0.6}) {
    int arrived = 0;
    for (std::uint64_t seed = 0; seed < kAgain; ++seed) {
      PlaceAside source(seed, {0.0, off});
      Random random(seed);
      const Spot start{0, {1.0, random.uniform(0.8, 3.2)}};
      const Goal goal{Goal::Kind::spot, 0, {1, {3.0, 2.0}}};
      const WalkOutcome o = test::walk_blindfolded(router, start, 0.0, goal, source, {}, seed);
      arrived += o.arrived ? 1 : 0;
    }
    EXPECT_GE(arrived, kAgain - 1) << off;
  }
}

TEST(ClosedLoop, NothingIsSaidTwiceInTenSecondsUnlessAsked) {
  for (const WalkOutcome& o : office().outcomes) {
    for (std::size_t i = 0; i < o.cues.size(); ++i) {
      for (std::size_t j = i + 1; j < o.cues.size(); ++j) {
        const Cue& a = o.cues[i].cue;
        const Cue& b = o.cues[j].cue;
        if (b.time_s - a.time_s >= 10.0) break;
        if (a.urgency == Urgency::asked || b.urgency == Urgency::asked) continue;
        EXPECT_FALSE(o.words[i] == o.words[j]) << o.words[i] << " at " << a.time_s << " and " << b.time_s;
      }
    }
  }
}

TEST(ClosedLoop, NoTurnTakesBackAnotherWithinFiveSeconds) {
  for (const WalkOutcome& o : office().outcomes) {
    for (std::size_t i = 1; i < o.cues.size(); ++i) {
      const Cue& a = o.cues[i - 1].cue;
      const Cue& b = o.cues[i].cue;
      if (a.kind != CueKind::turn || b.kind != CueKind::turn || b.time_s - a.time_s >= 5.0) continue;
      const bool sideways = sector_of(a.direction) != Sector::behind && sector_of(b.direction) != Sector::behind;
      EXPECT_FALSE(sideways && a.direction * b.direction < 0.0) << a.time_s;
    }
  }
}

TEST(ClosedLoop, TheSameWalkGivesTheSameCues) {
  const Building building = test::make_grid(2, 2);
  const Sum one = walk_many(building, 2);
  const Sum two = walk_many(building, 2);
  for (std::size_t i = 0; i < one.outcomes.size(); ++i) {
    EXPECT_EQ(one.outcomes[i].words, two.outcomes[i].words);
    EXPECT_EQ(one.outcomes[i].walked_m, two.outcomes[i].walked_m);
  }
}

}  // namespace
}  // namespace echoway
