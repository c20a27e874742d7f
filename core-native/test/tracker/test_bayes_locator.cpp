#include "echoway/tracker/bayes_locator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/units.hpp"
#include "plans/error_of.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"

namespace echoway {
namespace {

sim::Simulation walk_through(const Building& building, std::uint64_t seed, double seconds,
                             sim::Profile profile = sim::Profile::furnished) {
  sim::RandomWalkOptions options;
  options.duration_s = seconds;
  options.profile = profile;
  auto simulation = sim::simulate(building, sim::random_walk(building, options, seed));
  EXPECT_TRUE(simulation.ok());
  return std::move(*simulation);
}

struct Score {
  double mean_m = 0.0;
  double room_share = 0.0;
  std::vector<Pose2> track;
};

Score follow(Locator& locator, const Building& building, const sim::Simulation& s, bool hints, std::size_t from = 0) {
  Score score;
  std::size_t counted = 0;
  const auto judge = [&](std::size_t i) {
    const Estimate& e = locator.estimate();
    EXPECT_TRUE(is_finite(e.pose) && std::isfinite(e.sigma_m));
    score.track.push_back(e.pose);
    if (i < from) return;
    score.mean_m += plans::error_of(e, s.truth[i], building);
    score.room_share += e.room == building.find_room(s.truth[i].room);
    ++counted;
  };
  test::play(s, locator, judge, hints);
  score.mean_m /= static_cast<double>(counted);
  score.room_share /= static_cast<double>(counted);
  return score;
}

TEST(BayesLocator, KeepsHoldOfAWearerThroughRoomsAndDoors) {
  const Building building = test::small_office();
  const auto walk = walk_through(building, 3, 40.0);
  BayesLocator locator(building, {}, test::start_of(walk, building));
  const Score score = follow(locator, building, walk, true);
  EXPECT_LT(score.mean_m, 0.25);
  EXPECT_GT(score.room_share, 0.95);
}

// How many firings later than the wearer the estimate goes from room to room, in the mean; negative when it is early.
double lateness(Locator& locator, const Building& building, const sim::Simulation& walk) {
  std::vector<RoomIndex> said;
  test::play(walk, locator, [&](std::size_t) { said.push_back(locator.estimate().room); }, true);
  constexpr std::size_t kAbout = 16;
  double late = 0.0;
  int crossings = 0;
  for (std::size_t i = kAbout; i + kAbout < said.size(); ++i) {
    const RoomIndex to = building.find_room(walk.truth[i].room);
    if (walk.truth[i - 1].room == walk.truth[i].room) continue;
    const auto about = said.begin() + static_cast<std::ptrdiff_t>(i - kAbout);
    const auto entered = std::find(about, about + 2 * kAbout, to);
    late += static_cast<double>(entered - about) - static_cast<double>(kAbout);
    ++crossings;
  }
  EXPECT_GT(crossings, 1);
  return late / crossings;
}

// The walls are half a foot thick: a tracker for which a room ends behind its doorway comes two to three firings late.
TEST(BayesLocator, ARoomEndsInTheMiddleOfADoorway) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/similar-rooms");
  double late = 0.0;
  for (std::uint64_t seed = 11; seed <= 14; ++seed) {
    const auto walk = walk_through(building, seed, 90.0, sim::Profile::empty);
    BayesLocator locator(building, walk.scans.belt.apply_to({}), test::start_of(walk, building));
    late += lateness(locator, building, walk) / 4.0;
  }
  EXPECT_NEAR(late, 0.0, 1.0) << "firings";
}

// One walk among people, clutter and ghosts, told the start, followed with several seeds of the tracker.
std::vector<Score> follow_among_people(const Building& building, std::uint64_t seed, double seconds,
                                       std::uint64_t draws) {
  const auto walk = walk_through(building, seed * 101 + 7, seconds, sim::Profile::hard);
  std::vector<Score> scores;
  for (std::uint64_t draw = 0; draw < draws; ++draw) {
    BayesLocator locator(building, walk.scans.belt.apply_to({}), test::start_of(walk, building),
                         {.seed = seed + 1000 * draw});
    scores.push_back(follow(locator, building, walk, true));
  }
  return scores;
}

TEST(BayesLocator, LosesNobodyAmongPeopleAndClutter) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  for (std::uint64_t seed = 301; seed <= 308; ++seed) {
    EXPECT_LT(follow_among_people(building, seed, 60.0, 1).front().mean_m, 1.0) << "walk " << seed;
  }
}

// Most echoes come from what the plan does not know there, on these of two dozen walks more than on others.
TEST(BayesLocator, HoldsAWearerAmongMoreStrangersThanThingsOfThePlan) {
  constexpr std::uint64_t kDraws = 8;
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  double mean_m = 0.0;
  for (const std::uint64_t seed : {307, 310, 313, 323}) {
    for (const Score& score : follow_among_people(building, seed, 60.0, kDraws)) {
      EXPECT_LT(score.mean_m, 0.5) << "walk " << seed;
      mean_m += score.mean_m / (4.0 * kDraws);
    }
  }
  EXPECT_LT(mean_m, 0.15) << "metres";
}

// Where nothing explains the echoes for a while, some other place does so a little better; these walks were most often
// taken to be there.
TEST(BayesLocator, TakesNobodyForElsewhereBecauseNothingFits) {
  constexpr std::uint64_t kDraws = 4;
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/two-rooms");
  double mean_m = 0.0;
  double room_share = 0.0;
  for (const std::uint64_t seed : {140035, 140086, 140198}) {
    for (const Score& score : follow_among_people(building, seed, 80.0, kDraws)) {
      mean_m += score.mean_m / (3.0 * kDraws);
      room_share += score.room_share / (3.0 * kDraws);
    }
  }
  EXPECT_LT(mean_m, 0.4) << "metres";
  EXPECT_GT(room_share, 0.97);
}

// On a thigh the phone turns with every stride though the belt does not.
TEST(BayesLocator, HoldsAWearerWhosePhoneSwingsInATrouserPocket) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  double mean_m = 0.0;
  for (std::uint64_t seed = 4; seed <= 11; ++seed) {
    sim::RandomWalkOptions options;
    options.duration_s = 60.0;
    sim::Walk plan = sim::random_walk(building, options, seed * 101 + 7);
    plan.world.phone_swing_rad = degrees(16.0);
    plan.world.step_length_m = 0.4;
    const auto walk = *sim::simulate(building, plan);
    BayesLocator locator(building, walk.scans.belt.apply_to({}), test::start_of(walk, building), {.seed = seed});
    const double walk_m = follow(locator, building, walk, true).mean_m;
    EXPECT_LT(walk_m, 2.0) << "walk " << seed;
    mean_m += walk_m / 8.0;
  }
  EXPECT_LT(mean_m, 0.4) << "metres";
}

// Seven levels and 280 rooms, of which these are not like any other: a search takes its time, but not a minute.
TEST(BayesLocator, FindsAWearerOfWhomNothingIsKnownInALargeBuilding) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/westport-house");
  constexpr double kFoundBy = 25.0;
  for (const std::uint64_t seed : {100, 102}) {
    const auto walk = walk_through(building, seed * 101 + 7, 30.0);
    const auto by = std::ranges::lower_bound(walk.truth, kFoundBy, {}, &TruthRow::time_s) - walk.truth.begin();
    BayesLocator locator(building, walk.scans.belt.apply_to({}), {});
    const Score score = follow(locator, building, walk, true, static_cast<std::size_t>(by));
    EXPECT_LT(score.mean_m, 0.3) << "walk " << seed;
    EXPECT_GT(score.room_share, 0.95) << "walk " << seed;
  }
}

TEST(BayesLocator, FindsAWearerOfWhomNothingIsKnown) {
  // A share of many walks, not one: a single furnished walk may hide a wearer from any locator for half a minute.
  constexpr int kWalks = 8;
  const Building building = test::small_office();
  int found = 0;
  for (int seed = 1; seed <= kWalks; ++seed) {
    const auto walk = walk_through(building, static_cast<std::uint64_t>(seed), 40.0);
    BayesLocator locator(building, {}, {});
    const Score score = follow(locator, building, walk, true, walk.scans.firings.size() / 2);
    found += score.mean_m < 0.3 && score.room_share > 0.95 ? 1 : 0;
    RecordProperty("mean_m_" + std::to_string(seed), std::to_string(score.mean_m));
  }
  EXPECT_GE(found, 3 * kWalks / 4);
}

// Under a coat a belt hears what is near and nothing else. Silence says little then: a tracker that takes it for empty
// space places a third as many of these scans.
TEST(BayesLocator, PlacesAWearerWhoseBeltHearsOnlyWhatIsNear) {
  constexpr int kScans = 60;
  constexpr double kHeard = 1.3;    // Metres.
  constexpr double kSeconds = 2.8;  // Three passes.
  Building building;
  building.rooms.push_back(
      test::room_from_outline("box room", {{0, 0}, {3.0, 0}, {3.0, 1.1}, {1.8, 1.1}, {1.8, 2.6}, {0, 2.6}}));
  int placed = 0;
  for (std::uint64_t seed = 1; seed <= kScans; ++seed) {
    sim::Walk stand = sim::random_walk(building, {.duration_s = 1.0}, seed);
    stand.steps.clear();
    stand.add(sim::Pause{kSeconds});
    stand.world.furniture_per_m2 = stand.world.posts_per_m2 = stand.world.people_per_100m2 = 0.0;
    auto scan = *sim::simulate(building, stand);
    for (Firing& firing : scan.scans.firings) {
      if (firing.has_echo() && firing.range_m > kHeard) firing.range_m = Firing::kNoEcho;
    }
    BayesLocator locator(building, scan.scans.belt.apply_to({}), {}, {.seed = seed});
    placed += follow(locator, building, scan, false, scan.scans.firings.size() - 1).mean_m < 0.3;
  }
  RecordProperty("placed", placed);
  EXPECT_GT(placed, kScans / 3);
}

// A turn is followed by how the echoes move alone. In the middle of a room that looks alike from two sides it may be
// taken for the other way round, which two of these eight walks tempt to.
TEST(BayesLocator, FollowsTurnsThatNoGyroscopeTold) {
  constexpr int kWalks = 8;
  const auto building = load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  ASSERT_TRUE(building.ok());
  double mean_m = 0.0;
  for (std::uint64_t seed = 905; seed < 905 + kWalks; ++seed) {
    const auto walk = walk_through(*building, seed * 101 + 7, 80.0);
    BayesLocator locator(*building, {}, test::start_of(walk, *building));
    mean_m += follow(locator, *building, walk, false).mean_m / kWalks;
  }
  EXPECT_LT(mean_m, 0.3);
}

// A rectangle looks the same both ways round, for as long as one walks about in it.
TEST(BayesLocator, KeepsBothPlacesOfASymmetricRoomInMind) {
  constexpr double kKnown = 5.0;   // Seconds after which a first search has ended.
  const Building building = test::plain_hall();
  int firings = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto walk = walk_through(building, seed, 30.0);
    BayesLocator locator(building, {}, {});
    const auto holds = [&](Vec2 place) {
      return std::ranges::any_of(locator.hypotheses(),
                                 [&](const Hypothesis& h) { return distance(h.pose.position, place) < 0.6; });
    };
    test::play(walk, locator, [&](std::size_t i) {
      if (walk.scans.firings[i].time_s < kKnown) return;
      const Vec2 here = walk.truth[i].pose.position;
      kept += holds(here) && holds(test::kFarCorner - here) ? 1 : 0;
      ++firings;
    });
  }
  EXPECT_GT(kept, firings * 3 / 4);
}

TEST(BayesLocator, TakesTheFirstBearingsOfAnUnknownWearerFromTheirCompass) {
  // Two seconds after an unknown start a rectangular room looks the same both ways round; a compass settles it.
  constexpr int kWalks = 12;
  constexpr std::size_t kTwoSeconds = 32;
  const Building building = test::small_office();
  const auto facing_right = [&](bool compass) {
    int right = 0;
    for (int seed = 1; seed <= kWalks; ++seed) {
      auto walk = walk_through(building, static_cast<std::uint64_t>(seed), 10.0);
      BayesLocator locator(building, {}, {});
      const auto level_heading = [&](const TruthRow& row) {
        return building.room(building.find_room(row.room)).frame.heading + row.pose.heading;
      };
      if (compass) {
        const double said = level_heading(walk.truth.front()) + degrees(5.0);
        locator.on_motion({walk.scans.firings.front().time_s, MotionKind::heading, said});
      }
      std::size_t hint = 0;
      for (std::size_t i = 0; i < kTwoSeconds; ++i) {
        for (; hint < walk.motion.size() && walk.motion[hint].time_s <= walk.scans.firings[i].time_s; ++hint) {
          if (walk.motion[hint].kind == MotionKind::yaw_rate) locator.on_motion(walk.motion[hint]);
        }
        locator.on_firing(walk.scans.firings[i]);
      }
      const Estimate& e = locator.estimate();
      const double got = building.room(e.room).frame.heading + e.pose.heading;
      right += std::abs(wrap_angle(got - level_heading(walk.truth[kTwoSeconds - 1]))) < degrees(45.0) ? 1 : 0;
    }
    return right;
  };
  const int with_compass = facing_right(true);
  EXPECT_GE(with_compass, 3 * kWalks / 4);
  EXPECT_LT(facing_right(false), with_compass) << "the test would say nothing";
}

TEST(BayesLocator, GivesTheSameBitsOnEveryRun) {
  const Building building = test::small_office();
  const auto walk = walk_through(building, 7, 15.0);
  BayesLocator first(building, {}, {});
  BayesLocator second(building, {}, {});
  const Score a = follow(first, building, walk, true);
  const Score b = follow(second, building, walk, true);
  EXPECT_EQ(a.track, b.track);
}

// What a cover answers tells nothing about the air: a wearer would not be found again for as long as a search believes
// that sound is impossibly fast.
TEST(BayesLocator, LearnsNothingOfTheSpeedOfSoundUnderACover) {
  constexpr int kCovered = 3000;
  const Building building = test::small_office();
  const auto walk = walk_through(building, 3, 60.0);
  BayesLocator locator(building, {}, test::start_of(walk, building));
  const double before = walk.scans.firings.front().time_s - kCovered * 0.0624;
  for (int i = 0; i < kCovered; ++i) locator.on_firing({before + i * 0.0624, i % 15, 0.3});
  EXPECT_LT(std::abs(locator.estimate().sound_speed_scale - 1.0), 0.02);
  const Score score = follow(locator, building, walk, true, walk.scans.firings.size() / 2);
  EXPECT_LT(score.mean_m, 0.3);
}

TEST(BayesLocator, IgnoresFiringsThatNoBeltMakes) {
  const Building building = test::small_office();
  BayesLocator locator(building, {}, {RoomIndex{1}, Vec2{1, 1}, 0.0});
  EXPECT_TRUE(locator.on_firing({1.0, 0, 2.0}));
  EXPECT_FALSE(locator.on_firing({2.0, 15, 2.0}));
  EXPECT_FALSE(locator.on_firing({2.0, -1, 2.0}));
  EXPECT_FALSE(locator.on_firing({std::numeric_limits<double>::quiet_NaN(), 0, 2.0}));
  EXPECT_FALSE(locator.on_firing({2.0, 0, std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_FALSE(locator.on_firing({0.5, 0, 2.0})) << "time went back";
  EXPECT_TRUE(locator.on_firing({2.0, 1, Firing::kNoEcho}));
}

}  // namespace
}  // namespace echoway
