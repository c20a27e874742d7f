#include "echoway/guidance/guide.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "support/plans.hpp"

namespace echoway {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double kSlot = 0.0624;
const Start kTold{0, Vec2{1.0, 2.5}, 0.0};

Estimate at(double time_s, RoomIndex room, Vec2 position, double heading_deg) {
  Estimate e;
  e.time_s = time_s;
  e.room = room;
  e.pose = {position, degrees(heading_deg)};
  e.sigma_m = 0.1;
  e.sigma_heading_rad = degrees(3.0);
  e.room_probability = 0.98;
  e.state = TrackState::tracking;
  return e;
}

Estimate lost(double time_s) {
  Estimate e = at(time_s, 0, {1, 1}, 0.0);
  e.state = TrackState::lost;
  e.room_probability = 0.2;
  e.sigma_m = 3.0;
  return e;
}

/// What a belt hears that has `free_m` of room about one side of the chest, and little about the others.
auto free_about(double side, double free_m = 3.0) {
  return [=](double bearing) { return std::abs(wrap_angle(bearing - side)) < degrees(70.0) ? free_m : 0.6; };
}

/// The same with room on the left and on the right.
auto free_aside(double left_m, double right_m) {
  return [=](double bearing) {
    const bool aside = std::abs(std::abs(bearing) - kPi / 2) < degrees(70.0);
    if (!aside) return 0.6;
    return bearing > 0.0 ? left_m : right_m;
  };
}

std::vector<CueKind> kinds(const std::vector<Cue>& cues) {
  std::vector<CueKind> result;
  for (const Cue& cue : cues) result.push_back(cue.kind);
  return result;
}

/// A guide and its clock.
struct Listener {
  explicit Listener(const Building& building) : router(building), guide(router) {}

  std::vector<Cue> fetch() {
    std::vector<Cue> cues;
    Cue cue;
    while (guide.next_cue(cue)) cues.push_back(cue);
    return cues;
  }
  /// The same estimate for a while; what is said meanwhile.
  std::vector<Cue> stay(double seconds, Estimate e, std::span<const Hypothesis> places = {}) {
    for (const double end = now + seconds; now < end; now += kSlot) {
      e.time_s = now;
      guide.on_estimate(e, places);
    }
    return fetch();
  }
  std::vector<Cue> stand(double seconds, RoomIndex room, Vec2 position, double heading_deg) {
    return stay(seconds, at(0, room, position, heading_deg));
  }
  /// Walking straight ahead for one firing at `walking`'s speed, which moves.
  std::vector<Cue> step(Estimate& walking) {
    walking.pose.position = walking.pose.position + walking.speed_mps * kSlot * unit_from_angle(walking.pose.heading);
    return stay(kSlot, walking);
  }
  /// Turning slowly on the spot, as a lost wearer is asked to.
  std::vector<Cue> turn_about(double seconds, RoomIndex room, Vec2 position) {
    double heading = 0.0;
    for (const double end = now + seconds; now < end; now += kSlot) {
      heading += 40.0 * kSlot;
      guide.on_estimate(at(now, room, position, heading));
    }
    return fetch();
  }
  /// Whole scans in which the front sensor hears `ranges` in turn and the others nothing.
  std::vector<Cue> scan(std::initializer_list<double> ranges, const Estimate& pose) {
    for (const double range : ranges) {
      for (int sensor = 0; sensor < 15; ++sensor) {
        guide.on_firing({now, sensor, sensor == 0 ? range : Firing::kNoEcho});
        Estimate e = pose;
        e.time_s = now;
        guide.on_estimate(e);
        now += kSlot;
      }
    }
    return fetch();
  }

  /// Scans in which `range` says what the sensor that looks to a side of the chest hears.
  template <class Range>
  std::vector<Cue> hear(double seconds, const Estimate& pose, Range range, std::span<const Hypothesis> places = {}) {
    const BeltConfig belt;
    for (const double end = now + seconds; now < end;) {
      for (int sensor = 0; sensor < belt.sensors; ++sensor, now += kSlot) {
        guide.on_firing({now, sensor, range(wrap_angle(belt.bearing(sensor)))});
        Estimate e = pose;
        e.time_s = now;
        guide.on_estimate(e, places);
      }
    }
    return fetch();
  }

  Router router;
  Guide guide;
  double now = 0.0;
};

class GuideTest : public ::testing::Test {
 protected:
  Building building = [] {
    Building b = test::make_grid(2, 2);
    b.places.push_back({1, {4, 4}, "Lectern"});
    b.rooms[0].name = "Lobby";
    return b;
  }();
  Listener wearer{building};
  Guide& guide = wearer.guide;
};

TEST_F(GuideTest, NamesTheRoomOnceAndThenIsSilent) {
  EXPECT_THAT(kinds(wearer.stand(5.0, 0, {2, 2}, 0.0)), ElementsAre(CueKind::entering));
  EXPECT_THAT(wearer.stand(60.0, 0, {2, 2}, 0.0), IsEmpty());
}

TEST_F(GuideTest, TurnsTheWearerThenSendsThemStraight) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  const auto first = wearer.stand(4.0, 0, {1, 2.5}, 90.0);
  const auto turn = std::find_if(first.begin(), first.end(), [](const Cue& c) { return c.kind == CueKind::turn; });
  ASSERT_NE(turn, first.end());
  EXPECT_EQ(sector_of(turn->direction), Sector::right);
  const auto then = wearer.stand(4.0, 0, {1, 2.5}, 0.0);
  EXPECT_THAT(kinds(then), Contains(CueKind::go_straight));
  EXPECT_THAT(kinds(then), Not(Contains(CueKind::turn)));
}

TEST_F(GuideTest, SaysArrivedAndWhereThePlaceIs) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  const auto cues = wearer.stand(3.0, 1, {3.5, 4.0}, 90.0);
  const auto arrived = std::find_if(cues.begin(), cues.end(), [](const Cue& c) { return c.kind == CueKind::arrived; });
  ASSERT_NE(arrived, cues.end());
  EXPECT_EQ(sector_of(arrived->direction), Sector::right);
  (void)wearer.stand(10.0, 1, {3.5, 4.0}, 90.0);
  EXPECT_FALSE(guide.has_destination());
}

TEST_F(GuideTest, NobodyHasArrivedInARoomThatTheyMayNotHaveEntered) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {1, {0.7, 2.5}}}));
  Estimate before = at(0, 1, {0.2, 2.5}, 0.0);
  before.room_probability = 0.7;
  EXPECT_THAT(kinds(wearer.stay(6.0, before)), Not(Contains(CueKind::arrived)));
  EXPECT_THAT(kinds(wearer.stand(3.0, 1, {0.5, 2.5}, 0.0)), Contains(CueKind::arrived));
}

TEST_F(GuideTest, NobodyHasArrivedInARoomThatShowsForAMomentOnly) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {1, {0.7, 2.5}}}));
  for (int i = 0; i < 5; ++i) {
    EXPECT_THAT(kinds(wearer.stand(1.2, 0, {4.8, 2.5}, 0.0)), Not(Contains(CueKind::arrived)));
    EXPECT_THAT(kinds(wearer.stand(0.5, 1, {0.1, 2.5}, 0.0)), Not(Contains(CueKind::arrived)));
  }
}

TEST_F(GuideTest, NobodyHasArrivedOnAPlaceThatIsNotKnown) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(5.0, 1, {2.0, 2.5}, 0.0);
  Estimate blurred = at(0, 1, {3.3, 3.6}, 45.0);
  blurred.sigma_m = 1.2;
  EXPECT_THAT(kinds(wearer.stay(1.4, blurred)), Not(Contains(CueKind::arrived)));
}

TEST_F(GuideTest, NobodyHasArrivedWhereTheyAreThoughtToWalkOnWhileTheyComeToAStand) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  Estimate walking = at(0, 1, {4.0, 1.0}, 90.0);
  (void)wearer.stay(1.5, walking);
  walking.speed_mps = 0.7;
  std::vector<Cue> cues;
  for (; walking.pose.position.y < 2.7; walking.pose.position.y += 0.7 * kSlot) (void)wearer.stay(kSlot, walking);
  for (; walking.speed_mps > 0.25; walking.speed_mps -= 0.4 * kSlot) {  // has met something at 2.7
    walking.pose.position.y += walking.speed_mps * kSlot;
    for (const Cue& cue : wearer.stay(kSlot, walking)) cues.push_back(cue);
  }
  EXPECT_GT(walking.pose.position.y, 3.2) << "taken to be there";
  for (const Cue& cue : wearer.stand(6.0, 1, {4.0, 2.7}, 90.0)) cues.push_back(cue);
  EXPECT_THAT(kinds(cues), Not(Contains(CueKind::arrived)));
  EXPECT_TRUE(guide.has_destination());
}

TEST_F(GuideTest, WhoWalksUpVaguelyKnownIsStoppedAndToldThatTheyHaveArrivedOnceTheyStandThere) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  Estimate walking = at(0, 1, {4.0, 1.0}, 90.0);
  walking.sigma_m = 0.55;
  (void)wearer.stay(1.5, walking);
  walking.speed_mps = 0.7;
  std::vector<Cue> cues;
  for (; walking.pose.position.y < 3.8; walking.pose.position.y += 0.7 * kSlot) {
    for (const Cue& cue : wearer.stay(kSlot, walking)) cues.push_back(cue);
  }
  EXPECT_THAT(kinds(cues), Contains(CueKind::stop));
  EXPECT_THAT(kinds(cues), Not(Contains(CueKind::arrived)));
  EXPECT_THAT(kinds(wearer.stand(4.0, 1, {4.0, 3.8}, 90.0)), Contains(CueKind::arrived));
}

TEST_F(GuideTest, WhoStandsAtTheirDestinationIsToldSoInTheEndThoughTheEchoesDoNotFit) {
  (void)wearer.stand(3.0, 1, {4, 3.6}, 0.0);
  Estimate unfit = at(0, 1, {4, 3.6}, 0.0);
  unfit.state = TrackState::lost;
  ASSERT_TRUE(guide.set_destination("Lectern"));
  EXPECT_THAT(kinds(wearer.stay(4.0, unfit)), Not(Contains(CueKind::arrived))) << "it may be somewhere else";
  EXPECT_THAT(kinds(wearer.stay(6.0, unfit)), Contains(CueKind::arrived));
}

TEST_F(GuideTest, LeadsOnWhoWasTakenToHaveArrivedOnAVaguePlace) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  Estimate vague = at(0, 1, {3.5, 4.0}, 90.0);
  vague.sigma_m = 0.75;
  EXPECT_THAT(kinds(wearer.stay(3.0, vague)), Contains(CueKind::arrived));
  (void)wearer.stay(6.0, vague);
  EXPECT_TRUE(guide.has_destination());
  EXPECT_THAT(kinds(wearer.stand(8.0, 1, {2.6, 3.2}, 90.0)), Contains(CueKind::turn)) << "they are elsewhere after all";
}

TEST_F(GuideTest, LostItSaysSoAndNothingElseUntilItIsFound) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(5.0, 0, {1, 2.5}, 90.0);
  const auto cues = wearer.stay(30.0, lost(0));
  ASSERT_FALSE(cues.empty());
  EXPECT_EQ(cues.front().kind, CueKind::uncertain);
  for (const Cue& cue : cues) EXPECT_EQ(urgency_of(cue.kind), Urgency::broken) << to_string(cue.kind);
  const auto then = wearer.stand(4.0, 0, {1, 2.5}, 90.0);
  const auto found = std::find_if(then.begin(), then.end(), [](const Cue& c) { return c.kind == CueKind::found; });
  ASSERT_NE(found, then.end());
  EXPECT_EQ(found->tail.kind, CueKind::turn);
}

TEST_F(GuideTest, WhoIsFoundAndTurnedIsGivenTheTimeForIt) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(3.0, 0, {1, 2.5}, 90.0);
  (void)wearer.stay(8.5, lost(0));
  std::vector<Cue> found;
  while (found.empty() && wearer.now < 15.0) found = wearer.stand(kSlot, 0, {1, 2.5}, 90.0);
  ASSERT_THAT(kinds(found), ElementsAre(CueKind::found));
  ASSERT_EQ(found.front().tail.kind, CueKind::turn);
  EXPECT_THAT(wearer.stand(4.0, 0, {1, 2.5}, 90.0), IsEmpty()) << "half of it is listening";
}

TEST_F(GuideTest, BelievesAPlaceLessReadilyEachTimeItIsLostAgain) {
  (void)wearer.stand(3.0, 0, {1, 1.0}, 0.0);
  const auto seconds_until_found = [&] {
    (void)wearer.stay(4.0, lost(0));
    for (double s = 0.0; s < 10.0; s += 0.1) {
      for (const Cue& cue : wearer.stand(0.1, 0, {1, 1.0}, 0.0)) {
        if (cue.kind == CueKind::found) return s;
      }
    }
    return 1e9;
  };
  const double first = seconds_until_found();
  (void)seconds_until_found();
  EXPECT_GT(seconds_until_found(), 1.9 * first);
}

TEST_F(GuideTest, WhoIsFoundAgainAndAgainHearsItOnceInTenSeconds) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(3.0, 0, {1, 2.5}, 90.0);
  (void)wearer.stay(14.0, lost(0));
  ASSERT_THAT(kinds(wearer.stand(3.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::found));
  EXPECT_THAT(kinds(wearer.stay(2.5, lost(0))), Contains(CueKind::uncertain));
  EXPECT_THAT(wearer.stand(4.0, 0, {1, 2.5}, 90.0), IsEmpty()) << "nor is anybody led from a place that comes and goes";
  EXPECT_THAT(kinds(wearer.stand(6.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::found));
}

TEST_F(GuideTest, WhoAsksWhereTheyAreHearsThatTheyAreFoundHoweverSoon) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 90.0);
  (void)wearer.stay(14.0, lost(0));
  ASSERT_THAT(kinds(wearer.stand(3.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::found));
  EXPECT_THAT(kinds(wearer.stay(2.5, lost(0))), Contains(CueKind::uncertain));
  EXPECT_THAT(wearer.stand(3.5, 0, {1, 2.5}, 90.0), IsEmpty());
  guide.where_am_i();
  EXPECT_THAT(kinds(wearer.stand(2.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::found));
}

TEST_F(GuideTest, ABriefDoubtIsNotWorthAWord) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  (void)wearer.stay(1.0, lost(0));
  EXPECT_THAT(wearer.stand(5.0, 0, {1, 2.5}, 0.0), IsEmpty());
}

TEST_F(GuideTest, LostItAsksForAnActionThatTells) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  const std::vector<Hypothesis> places = {{0, {{2, 2}, 0.1}, 0.2, 0.5}, {1, {{3, 2}, 0.4}, 0.2, 0.45}};
  const auto cues = kinds(wearer.stay(15.0, lost(0), places));
  EXPECT_TRUE(std::count(cues.begin(), cues.end(), CueKind::probe_turn) +
              std::count(cues.begin(), cues.end(), CueKind::probe_step));
}

/// Which way a lost wearer is asked to go, from the chest; none when a line asks for something else.
std::optional<double> way_asked_for(const Cue& cue) {
  if (cue.kind == CueKind::probe_step || cue.kind == CueKind::go_straight) return cue.direction;
  const bool goes = cue.kind == CueKind::turn && cue.tail.present && cue.tail.kind == CueKind::go_straight;
  return goes ? std::optional(cue.direction) : std::nullopt;
}

TEST_F(GuideTest, LostItSendsTheWearerOnlyWhereTheBeltHearsThatItIsFree) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  const auto cues = wearer.hear(40.0, lost(0), free_about(kPi / 2));
  int asked = 0;
  for (const Cue& cue : cues) {
    const auto way = way_asked_for(cue);
    if (!way) continue;
    ++asked;
    EXPECT_EQ(sector_of(*way), Sector::left);
    EXPECT_LE(cue.tail.distance_m, 2.2) << "not up to what is heard there";
  }
  EXPECT_GE(asked, 1);
}

TEST_F(GuideTest, LostItAsksForNoStepAsideOrBack) {
  // To who counts steps, and does not see which way they go, they are steps ahead.
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  for (const double free : {0.0, kPi / 2, -kPi / 2, kPi}) {
    for (const Cue& cue : wearer.hear(60.0, lost(0), free_about(free))) {
      if (cue.kind == CueKind::probe_step) {
        EXPECT_EQ(sector_of(cue.direction), Sector::ahead);
      }
    }
  }
}

TEST_F(GuideTest, LostItLeadsOnAndNotToAndFro) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  // Free on both sides, and a little farther to the left whichever way the wearer faces.
  const auto corridor = free_aside(3.2, 3.0);
  Estimate somewhere = lost(0);
  std::vector<double> ways;  // by where the chest faced at first
  for (int turn = 0; turn < 12; ++turn) {
    for (const Cue& cue : wearer.hear(14.0, somewhere, corridor)) {
      if (const auto way = way_asked_for(cue)) ways.push_back(wrap_angle(*way + somewhere.pose.heading));
    }
    for (int i = 0; i < 60; ++i) {  // half about
      somewhere.pose.heading = wrap_angle(somewhere.pose.heading + degrees(3.0));
      (void)wearer.stay(kSlot, somewhere);
    }
  }
  ASSERT_GE(ways.size(), 3U);
  for (const double way : ways) EXPECT_NEAR(std::abs(wrap_angle(way - ways.front())), 0.0, degrees(15.0));
}

TEST_F(GuideTest, LostItSearchesOnTheWayThatTheBestGuessTells) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {0, {2.5, 4.0}}}));
  (void)wearer.stand(3.0, 0, {2.5, 1.0}, 0.0);
  Estimate guess = lost(0);
  guess.pose = {{2.5, 1.0}, 0.0};
  // A little farther to the right.
  const auto hall = free_aside(3.0, 3.2);
  std::vector<double> ways;
  for (const Cue& cue : wearer.hear(40.0, guess, hall)) {
    if (const auto way = way_asked_for(cue)) ways.push_back(*way);
  }
  ASSERT_FALSE(ways.empty());
  EXPECT_EQ(sector_of(ways.front()), Sector::left);
}

/// Two rooms `width` metres wide, one above the other; stairs a metre before the end, and upstairs a desk at the far
/// end.
Building two_levels(double width) {
  Building b;
  b.rooms.push_back(test::make_box("1", width, 4));
  b.rooms.push_back(test::make_box("2", width, 4));
  b.rooms[1].level = 1;
  b.links.push_back({LevelLinkKind::stairs, 0, {width - 1, 2}, 1, {width - 1, 2}});
  b.places.push_back({1, {1, 2}, "Desk"});
  return b;
}

TEST(Guide, ALostWearerIsAskedForNoMoreThanAStepWhereThereMayBeStairs) {
  const Building b = two_levels(12);
  const auto longest_walk = [&](Vec2 place) {
    Listener wearer(b);
    (void)wearer.stand(3.0, 0, {5, 2}, 0.0);
    const std::vector<Hypothesis> places = {{0, {place, 0.0}, 0.2, 0.5}};
    double longest = 0.0;
    for (int i = 0; i < 60; ++i) {
      for (const Cue& cue : wearer.hear(1.0, lost(0), free_about(0.0, 3.5), places)) {
        if (way_asked_for(cue)) longest = std::max({longest, cue.distance_m, cue.tail.distance_m, 0.6});
      }
    }
    return longest;
  };
  EXPECT_GT(longest_walk({2, 2}), 1.5);
  EXPECT_DOUBLE_EQ(longest_walk({9, 2}), 0.6);
}

TEST_F(GuideTest, LostItAsksForNoStepWhereNothingIsHeardToBeFree) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  const auto near = wearer.hear(40.0, lost(0), [](double) { return 0.6; });
  EXPECT_THAT(kinds(near), Contains(CueKind::probe_turn));
  EXPECT_THAT(kinds(near), Not(Contains(CueKind::probe_step)));
  const auto silent = wearer.hear(40.0, lost(0), [](double) { return Firing::kNoEcho; });
  EXPECT_THAT(kinds(silent), Not(Contains(CueKind::probe_step))) << "a wall that is met aslant is silent too";
}

TEST_F(GuideTest, LostItTakesAWallBeforeTheChestForNoHand) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  const auto wall = [](double bearing) { return std::abs(bearing) < 0.1 ? 0.2 : 3.0; };
  for (const Cue& cue : wearer.hear(40.0, lost(0), wall)) {
    const auto way = way_asked_for(cue);
    EXPECT_TRUE(!way || sector_of(*way) != Sector::ahead) << to_string(cue.kind) << " at " << cue.time_s;
  }
}

/// The ways that a lost wearer is sent by `wearer`'s guide in 40 s of hearing `range`, from the chest.
template <class W, class Range>
std::vector<double> ways_asked_for(W& wearer, Range range) {
  std::vector<double> ways;
  for (const Cue& cue : wearer.hear(40.0, lost(0), range)) {
    if (const auto way = way_asked_for(cue)) ways.push_back(*way);
  }
  return ways;
}

TEST_F(GuideTest, LostItSendsTheWearerRatherToWhereSomethingAnswers) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  // A wall on the left, too near to be heard: silent are all who look there and ahead.
  const auto ways = ways_asked_for(wearer, [](double bearing) {
    if (bearing > degrees(-10.0) && bearing < degrees(100.0)) return Firing::kNoEcho;
    return bearing < 0.0 && bearing > degrees(-130.0) ? 1.4 : 0.6;
  });
  ASSERT_FALSE(ways.empty());
  for (const double way : ways) EXPECT_LT(way, degrees(-20.0));
}

TEST_F(GuideTest, LostItSendsTheWearerRatherToWhereTheLikelyPlacesHaveNoWall) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  const std::vector<Hypothesis> places = {{0, {{0.3, 2.5}, kPi}, 0.3, 0.8}, {0, {{2.5, 2.5}, 0.0}, 0.3, 0.2}};
  const auto farther_ahead = [](double bearing) { return std::abs(bearing) < degrees(80.0) ? 3.0 : 2.0; };
  const auto cues = wearer.hear(40.0, lost(0), farther_ahead, places);
  int asked = 0;
  for (const Cue& cue : cues) {
    const auto way = way_asked_for(cue);
    if (!way) continue;
    ++asked;
    EXPECT_NE(sector_of(*way), Sector::ahead) << "a wall that is too near to be heard";
  }
  EXPECT_GE(asked, 1);
}

TEST_F(GuideTest, LostItDoesNotSendTheWearerWhereAnEchoMayBeAHandOrAWall) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  const auto ways = ways_asked_for(wearer, [](double bearing) {
    if (bearing > degrees(60.0) && bearing < degrees(125.0)) return 0.22;
    return std::abs(bearing) < degrees(20.0) || std::abs(bearing) > degrees(130.0) ? 0.6 : 1.4;
  });
  ASSERT_FALSE(ways.empty());
  for (const double way : ways) EXPECT_NE(sector_of(way), Sector::left);
}

TEST_F(GuideTest, LostItKeepsAWalkerFromWhatTheBeltHearsAhead) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  Estimate walking = lost(0);
  walking.speed_mps = 0.8;
  const auto ahead = [](double range) {
    return [range](double bearing) { return std::abs(bearing) < 0.1 ? range : 5.0; };
  };
  EXPECT_THAT(kinds(wearer.hear(6.0, walking, ahead(4.0))), Not(Contains(CueKind::stop)));
  EXPECT_THAT(kinds(wearer.hear(6.0, walking, ahead(0.8))), Contains(CueKind::stop));
}

TEST_F(GuideTest, EchoesThatDoNotFitAreNoLossYetWhileThePlaceGoesOnSteadily) {
  (void)wearer.stand(10.0, 0, {1, 2.5}, 0.0);
  Estimate unfit = at(0, 0, {1, 2.5}, 0.0);
  unfit.state = TrackState::lost;
  EXPECT_THAT(wearer.stay(25.0, unfit), IsEmpty());
  EXPECT_THAT(kinds(wearer.stay(8.0, unfit)), Contains(CueKind::uncertain));
}

TEST_F(GuideTest, WhoIsNarrowlyKnownWhereTheyWereIsFoundAgainThoughTheEchoesDoNotFit) {
  (void)wearer.stand(10.0, 0, {1, 2.5}, 0.0);
  EXPECT_THAT(kinds(wearer.stay(4.0, lost(0))), Contains(CueKind::uncertain));
  Estimate elsewhere = at(0, 3, {1, 2.5}, 0.0);  // no door leads there from room 0
  elsewhere.state = TrackState::lost;
  EXPECT_THAT(kinds(wearer.stay(8.0, elsewhere)), Not(Contains(CueKind::found)));
  Estimate unfit = at(0, 0, {1, 2.5}, 0.0);
  unfit.state = TrackState::lost;
  EXPECT_THAT(kinds(wearer.stay(8.0, unfit)), Contains(CueKind::found));
}

TEST_F(GuideTest, TellsNothingOfTheWayFromAPlaceThatHasJustJumped) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {0, {4, 1.0}}}));
  (void)wearer.stand(10.0, 0, {2.6, 1.0}, 0.0);
  EXPECT_THAT(wearer.stand(1.5, 0, {4, 1.0}, 0.0), IsEmpty());
  EXPECT_THAT(kinds(wearer.stand(3.0, 0, {4, 1.0}, 0.0)), Contains(CueKind::arrived));
}

TEST_F(GuideTest, APlaceThatNobodyCanHaveWalkedToIsBelievedOnceItHasStoodATurn) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(10.0, 0, {1, 2.5}, 0.0);
  const auto doubted = kinds(wearer.stand(8.0, 3, {1, 2.5}, 0.0));  // no door leads there from room 0
  EXPECT_THAT(doubted, Contains(CueKind::uncertain));
  EXPECT_THAT(doubted, Not(Contains(CueKind::turn)));
  EXPECT_THAT(doubted, Not(Contains(CueKind::found)));
  EXPECT_THAT(kinds(wearer.turn_about(6.0, 3, {1, 2.5})), Contains(CueKind::found));
  EXPECT_THAT(kinds(wearer.stand(20.0, 3, {1, 2.5}, 0.0)), Not(Contains(CueKind::uncertain))) << "then it counts";
}

TEST_F(GuideTest, WhoIsBackWhereTheyWereNeedNotTurnToBeBelieved) {
  (void)wearer.stand(10.0, 0, {1, 2.5}, 0.0);
  EXPECT_THAT(kinds(wearer.stand(5.0, 3, {1, 2.5}, 0.0)), Contains(CueKind::uncertain));
  EXPECT_THAT(kinds(wearer.stand(5.0, 0, {1, 2.5}, 0.0)), Contains(CueKind::found));
}

TEST_F(GuideTest, WhoTurnsIsToldTheWayOnceTheyStandStill) {
  (void)wearer.turn_about(2.0, 0, {1, 2.5});
  ASSERT_TRUE(guide.set_destination("Lectern"));
  const auto meanwhile = kinds(wearer.turn_about(6.0, 0, {1, 2.5}));
  EXPECT_THAT(meanwhile, Not(Contains(CueKind::turn)));
  EXPECT_THAT(meanwhile, Not(Contains(CueKind::go_straight)));
  EXPECT_THAT(kinds(wearer.stand(6.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::turn));
}

TEST_F(GuideTest, WhoIsFoundWhileTheyTurnIsNotToldWhichWayYet) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  (void)wearer.stay(12.0, lost(0));
  const auto cues = wearer.turn_about(4.0, 0, {1, 2.5});
  const auto found = std::find_if(cues.begin(), cues.end(), [](const Cue& c) { return c.kind == CueKind::found; });
  ASSERT_NE(found, cues.end());
  EXPECT_FALSE(found->tail.present);
}

TEST_F(GuideTest, WhoIsFoundAsTheyWalkIsNotToldATurnThatTheyWouldMakeTooLate) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(3.0, 0, {1, 2.5}, 90.0);
  (void)wearer.stay(12.0, lost(0));
  Estimate walking = at(0, 0, {1.0, 1.0}, 90.0);
  walking.speed_mps = 0.6;
  std::vector<Cue> cues;
  while (cues.empty() && wearer.now < 25.0) {
    walking.pose.position.y += 0.6 * kSlot;
    cues = wearer.stay(kSlot, walking);
  }
  ASSERT_THAT(kinds(cues), ElementsAre(CueKind::found));
  EXPECT_FALSE(cues.front().tail.present);
}

TEST_F(GuideTest, WhoIsFoundAsTheySetOffIsLedOnceTheyWalk) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {0, {2.5, 4.3}}}));
  (void)wearer.stand(3.0, 0, {2.5, 1.0}, 0.0);
  const auto ahead = free_about(0.0);
  Estimate guess = lost(0);
  guess.pose = {{2.5, 1.0}, 0.0};
  std::vector<Cue> asked;
  const auto to_walk = [](const Cue& cue) { return cue.kind == CueKind::go_straight; };
  while (wearer.now < 60.0 && std::none_of(asked.begin(), asked.end(), to_walk)) {
    asked = wearer.hear(0.9, guess, ahead);
  }
  ASSERT_THAT(kinds(asked), Contains(CueKind::go_straight));
  const auto cues = wearer.hear(2.5, at(0, 0, {2.5, 1.0}, 0.0), ahead);  // found before the first step
  ASSERT_THAT(kinds(cues), ElementsAre(CueKind::found));
  EXPECT_FALSE(cues.front().tail.present) << "it would be made at the end of the walk";
}

TEST_F(GuideTest, WhoStandsInADoorwayIsNotLostBetweenItsRooms) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {1, {3, 2.5}}}));
  (void)wearer.stand(6.0, 0, {4.9, 2.5}, 0.0);
  Estimate here = at(0, 0, {4.95, 2.5}, 0.0);
  Estimate beyond = at(0, 1, {0.05, 2.5}, 0.0);
  std::vector<CueKind> heard;
  for (int i = 0; i < 20; ++i) {
    Estimate& e = i % 2 == 0 ? beyond : here;
    e.room_probability = 0.45;
    const std::vector<Hypothesis> places = {{e.room, e.pose, 0.1, 0.97}};
    for (const Cue& cue : wearer.stay(1.0, e, places)) heard.push_back(cue.kind);
  }
  EXPECT_THAT(heard, Not(Contains(CueKind::uncertain))) << "the place is known, whichever room it counts to";
  EXPECT_THAT(heard, Not(Contains(CueKind::entering))) << "nor have they entered and left it again and again";
}

TEST_F(GuideTest, WhoHasStoodInTheNextRoomForLongIsThere) {
  (void)wearer.stand(6.0, 0, {4.9, 2.5}, 0.0);
  EXPECT_THAT(kinds(wearer.stand(8.0, 1, {0.1, 2.5}, 0.0)), Contains(CueKind::entering));
}

TEST_F(GuideTest, WhoMissedThatTheyArrivedMayAskThoughTheyWereLostMeanwhile) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  EXPECT_THAT(kinds(wearer.stand(8.0, 1, {4, 3.6}, 0.0)), Contains(CueKind::arrived));
  (void)wearer.stay(12.0, lost(0));
  (void)wearer.turn_about(6.0, 1, {4, 3.6});
  EXPECT_TRUE(guide.repeat());
  EXPECT_THAT(kinds(wearer.stand(4.0, 1, {4, 3.6}, 0.0)), Contains(CueKind::arrived));
}

TEST_F(GuideTest, WhoWasStoppedMayAskForWhatWasToldBefore) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  EXPECT_THAT(kinds(wearer.stand(8.0, 1, {4, 3.6}, 0.0)), Contains(CueKind::arrived));
  Estimate walking = lost(0);
  walking.speed_mps = 0.8;
  const auto wall = [](double bearing) { return std::abs(bearing) < 0.1 ? 0.8 : 5.0; };
  EXPECT_THAT(kinds(wearer.hear(12.0, walking, wall)), Contains(CueKind::stop));
  (void)wearer.turn_about(6.0, 1, {4, 3.6});
  EXPECT_TRUE(guide.repeat());
  const auto cues = kinds(wearer.stand(4.0, 1, {4, 3.6}, 0.0));
  EXPECT_THAT(cues, Contains(CueKind::arrived));
  EXPECT_THAT(cues, Not(Contains(CueKind::stop))) << "they stand already";
}

TEST_F(GuideTest, WhatALostWearerWasAskedToDoIsNotRepeatedOnceTheyAreFound) {
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  (void)wearer.stay(12.0, lost(0));
  EXPECT_THAT(kinds(wearer.stand(4.0, 0, {1, 2.5}, 0.0)), Contains(CueKind::found));
  EXPECT_FALSE(guide.repeat());
}

TEST_F(GuideTest, GivesNoPreciseInstructionWhenUnsure) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(3.0, 0, {1, 2.5}, 0.0);
  Estimate unsure = at(0, 0, {1, 2.5}, 30.0);  // 30 degrees off: a fine correction
  unsure.sigma_m = 1.0;
  for (const Cue& cue : wearer.stay(20.0, unsure)) {
    EXPECT_NE(cue.kind, CueKind::turn);
    EXPECT_NE(cue.kind, CueKind::door);
    EXPECT_TRUE(cue.distance_m < 0.0 || cue.sigma_m >= 0.75) << "a number would pretend to know";
  }
}

TEST(Guide, TellsInPassingOfExitsPlacesAndStairsWithoutADestination) {
  Building b;
  b.rooms.push_back(test::make_box("hall", 20, 4));
  b.rooms.push_back(test::make_box("upstairs", 20, 4));
  b.rooms[1].level = 1;
  b.places.push_back({0, {5, 3}, "Desk"});
  b.exits.push_back({0, {10, 3.2}, "Garden door"});
  b.links.push_back({LevelLinkKind::stairs, 0, {15, 3}, 1, {15, 3}});
  Listener wearer(b);
  std::vector<CueKind> told;
  Estimate walking = at(0, 0, {1.0, 2.0}, 0.0);
  walking.speed_mps = 0.8;
  while (walking.pose.position.x < 18.0) {
    for (const Cue& cue : wearer.stay(kSlot, walking)) told.push_back(cue.kind);
    walking.pose.position.x += 0.8 * kSlot;
  }
  EXPECT_THAT(told, ElementsAre(CueKind::entering, CueKind::place, CueKind::exit, CueKind::stairs));
}

TEST_F(GuideTest, AnswersWhereAmI) {
  (void)wearer.stand(3.0, 0, {2.5, 4.0}, 0.0);
  guide.where_am_i();
  const auto cues = wearer.stand(10.0, 0, {2.5, 4.0}, 0.0);
  ASSERT_THAT(kinds(cues), ElementsAre(CueKind::room_here, CueKind::facing, CueKind::door));
  EXPECT_NEAR(cues[1].distance_m, 2.5, 0.1);
  EXPECT_EQ(sector_of(cues[2].direction), Sector::left);
}

TEST_F(GuideTest, TellsOfAPlaceOnceAnApproachToWhoWalksWithoutADestination) {
  Estimate e = at(0, 1, {1.0, 1.0}, 0.0);
  e.speed_mps = 0.6;
  // Straight there, then on the spot for as long, as if round and round.
  const auto walk = [&](Vec2 to, double heading_deg) {
    const Vec2 from = e.pose.position;
    e.pose.heading = degrees(heading_deg);
    std::vector<Cue> cues;
    for (double share = 0.0; share < 2.0; share += 0.01) {
      e.pose.position = from + std::min(share, 1.0) * (to - from);
      const auto said = wearer.stay(0.1, e);
      cues.insert(cues.end(), said.begin(), said.end());
    }
    return cues;
  };
  (void)walk({1.0, 1.0}, 0.0);
  const auto near = walk({3.0, 4.0}, 90.0);
  ASSERT_EQ(std::count_if(near.begin(), near.end(), [](const Cue& c) { return c.kind == CueKind::place; }), 1);
  const Cue place = *std::find_if(near.begin(), near.end(), [](const Cue& c) { return c.kind == CueKind::place; });
  EXPECT_EQ(sector_of(place.direction), Sector::right);
  EXPECT_EQ(place.urgency, Urgency::place);
  (void)walk({0.2, 0.2}, 0.0);  // out of its reach
  EXPECT_THAT(kinds(walk({3.0, 4.0}, 90.0)), Contains(CueKind::place)) << "another approach";
  EXPECT_THAT(kinds(wearer.stand(20.0, 0, {2, 2}, 0.0)), Not(Contains(CueKind::place))) << "another room";
}

TEST_F(GuideTest, WhoFacesALittleOffOnAPlaceThatIsHardlyKnownIsAskedToTurnSlowly) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(1.5, 0, {1, 2.5}, 0.0);
  Estimate vague = at(0, 0, {1, 2.5}, 32.0);
  vague.sigma_m = 1.0;
  const auto cues = kinds(wearer.stay(15.0, vague));
  EXPECT_THAT(cues, Contains(CueKind::probe_turn)) << "silence would leave them there for good";
  EXPECT_THAT(cues, Not(Contains(CueKind::turn)));
}

TEST_F(GuideTest, WhoStandsWhereTheEchoesDoNotFitIsToldASlightTurnToo) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  Estimate unfit = at(0, 0, {1, 2.5}, 32.0);
  (void)wearer.stand(1.5, 0, {1, 2.5}, 0.0);
  unfit.state = TrackState::lost;
  const auto cues = wearer.stay(15.0, unfit);
  const auto turns = [](const Cue& cue) { return cue.kind == CueKind::turn || cue.tail.present; };
  const auto turn = std::find_if(cues.begin(), cues.end(), turns);
  ASSERT_NE(turn, cues.end()) << "without it nobody would ever face their way";
  EXPECT_EQ(sector_of(turn->kind == CueKind::turn ? turn->direction : turn->tail.direction), Sector::slightly_right);
}

/// A wall heard to that side of the chest where the plan has none.
auto wall_heard(double direction_deg, double range_m) {
  return [=](double bearing) { return std::abs(bearing - degrees(direction_deg)) < 0.1 ? range_m : Firing::kNoEcho; };
}

TEST_F(GuideTest, NobodyIsSentIntoAWallThatTheBeltHearsThoughThePlanHasNone) {
  const Estimate here = at(0, 0, {2, 2.5}, 0.0);
  for (const auto& wall : {wall_heard(0.0, 0.22), wall_heard(48.0, 0.16)}) {
    Listener facing(building);
    (void)facing.hear(3.0, here, wall);
    ASSERT_TRUE(facing.guide.set_destination({Goal::Kind::spot, 0, {0, {4, 2.5}}}));
    const auto cues = facing.hear(12.0, here, wall);
    EXPECT_FALSE(cues.empty());
    for (const Cue& cue : cues) EXPECT_NE(cue.kind, CueKind::go_straight) << cue.time_s;
  }
}

TEST(Guide, WhoHasNoOtherWayThanAWallThatTheBeltHearsIsAskedToTurnSlowly) {
  Building narrow;
  narrow.rooms.push_back(test::make_box("passage", 8.0, 1.0));
  Listener wearer(narrow);
  const Estimate here = at(0, 0, {2, 0.5}, 0.0);
  (void)wearer.hear(3.0, here, wall_heard(0.0, 0.22));
  ASSERT_TRUE(wearer.guide.set_destination({Goal::Kind::spot, 0, {0, {6, 0.5}}}));
  EXPECT_THAT(kinds(wearer.hear(16.0, here, wall_heard(0.0, 0.22))), Contains(CueKind::probe_turn));
}

/// The first line that tells where to go.
std::optional<Cue> first_step(const std::vector<Cue>& cues) {
  const auto step = std::find_if(cues.begin(), cues.end(), [](const Cue& c) {
    return c.kind == CueKind::turn || c.kind == CueKind::bear || c.kind == CueKind::go_straight;
  });
  return step == cues.end() ? std::nullopt : std::optional(*step);
}

/// Where a wearer who is vaguely known to stand along a wall is sent first; their way is to their right, along it.
std::optional<Cue> first_step_beside_a_wall(double heard_right_m) {
  Building b;
  b.rooms.push_back(test::make_box("hall", 12, 2.4));
  Listener wearer(b);
  Estimate here = at(0, 0, {4.0, 1.85}, 115.0);
  here.sigma_m = 0.35;
  const auto heard = [=](double bearing) {
    return std::abs(bearing + degrees(85.0)) < 0.25 ? heard_right_m : Firing::kNoEcho;
  };
  (void)wearer.hear(3.0, here, heard);
  EXPECT_TRUE(wearer.guide.set_destination({Goal::Kind::spot, 0, {0, {9.0, 1.6}}}));
  return first_step(wearer.hear(8.0, here, heard));
}

TEST(Guide, WhoHearsThatItIsFreeIsTurnedThereThoughTheWallIsNotSurelyFarEnough) {
  const auto step = first_step_beside_a_wall(1.6);
  ASSERT_TRUE(step);
  EXPECT_EQ(step->kind, CueKind::turn);
  EXPECT_FALSE(step->tail.present) << "no step aside first";
  EXPECT_LT(step->direction, 0.0);
  for (const double heard : {0.6, Firing::kNoEcho}) {
    const auto otherwise = first_step_beside_a_wall(heard);
    EXPECT_TRUE(!otherwise || otherwise->tail.present || otherwise->direction > 0.0) << heard << ": it may be the wall";
  }
}

/// Where a wearer is soon sent who is vaguely known to stand before a door, and hears something ahead.
std::optional<Cue> first_step_before_a_door(double heard_ahead_m) {
  const Building rooms = test::make_grid(2, 1, 4.0);
  Listener wearer(rooms);
  Estimate here = at(0, 0, {3.5, 2.0}, 0.0);
  here.sigma_m = 0.35;
  const auto heard = wall_heard(0.0, heard_ahead_m);
  (void)wearer.hear(3.0, here, heard);
  EXPECT_TRUE(wearer.guide.set_destination({Goal::Kind::spot, 0, {1, {3.0, 2.0}}}));
  return first_step(wearer.hear(5.0, here, heard));
}

TEST(Guide, WhoHearsTheNextRoomThroughTheDoorIsSentThroughItWithoutWaitingToBeKnownBetter) {
  const auto step = first_step_before_a_door(1.8);
  ASSERT_TRUE(step);
  EXPECT_EQ(step->kind, CueKind::go_straight);
  EXPECT_GT(step->distance_m, 1.0) << "into the next room";
  for (const double heard : {0.9, Firing::kNoEcho}) {
    EXPECT_FALSE(first_step_before_a_door(heard)) << heard << ": it may be the wall";
  }
}

TEST_F(GuideTest, WhoHearsAWallWhereTheDoorShouldBeIsLedAlongItAndNotIntoIt) {
  const Estimate before_door = at(0, 0, {4.6, 2.5}, 0.0);
  (void)wearer.hear(3.0, before_door, wall_heard(0.0, 0.25));
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {1, {3, 2.5}}}));
  const auto cues = wearer.hear(30.0, before_door, wall_heard(0.0, 0.25));
  const auto door = std::find_if(cues.begin(), cues.end(), [](const Cue& c) { return c.kind == CueKind::door; });
  ASSERT_NE(door, cues.end());
  EXPECT_NE(sector_of(door->direction), Sector::ahead);
  const auto step = first_step(cues);
  ASSERT_TRUE(step);
  EXPECT_EQ(step->kind, CueKind::turn);
  EXPECT_GT(std::abs(step->direction), degrees(45.0));
}

TEST_F(GuideTest, WhoWalksIntoTheFrameOfADoorHearsWhereTheDoorIsAndIsLedThere) {
  for (const double side : {1.0, -1.0}) {
    Listener bumps(building);
    ASSERT_TRUE(bumps.guide.set_destination({Goal::Kind::spot, 0, {1, {3, 2.5}}}));
    EXPECT_THAT(kinds(bumps.stand(6.0, 0, {4.0, 2.5}, side * 8.0)), Contains(CueKind::go_straight));
    Estimate walking = at(0, 0, {4.0, 2.5}, side * 8.0);
    walking.speed_mps = 0.6;
    for (const double end = bumps.now + 1.1; bumps.now < end;) (void)bumps.step(walking);
    const auto cues = bumps.stand(12.0, 0, walking.pose.position, side * 8.0);
    const auto door = std::find_if(cues.begin(), cues.end(), [](const Cue& c) { return c.kind == CueKind::door; });
    ASSERT_NE(door, cues.end()) << side;
    EXPECT_LT(side * door->direction, 0.0) << "the frame was met on the side that they walked to";
    const auto step = first_step(cues);
    ASSERT_TRUE(step) << side;
    EXPECT_LT(side * step->direction, 0.0) << side;
  }
}

TEST_F(GuideTest, RepeatsTheLastInstructionWhenAsked) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  EXPECT_FALSE(guide.repeat()) << "nothing was told yet";
  (void)wearer.stand(2.0, 0, {1, 2.5}, 90.0);
  EXPECT_TRUE(guide.repeat());
  EXPECT_THAT(kinds(wearer.stand(3.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::turn));
}

TEST_F(GuideTest, AThingIsNotToldAgainToWhoStandsBeforeIt) {
  const auto before = [&](double seconds, const Estimate& pose) {
    return wearer.hear(seconds, pose, [](double bearing) { return std::abs(bearing) < 0.1 ? 0.9 : Firing::kNoEcho; });
  };
  EXPECT_THAT(kinds(before(30.0, at(0, 0, {2, 2}, 0.0))), Contains(CueKind::obstacle).Times(1));
  EXPECT_THAT(kinds(before(12.0, at(0, 0, {2.05, 2}, 5.0))), Not(Contains(CueKind::obstacle)));
  EXPECT_THAT(kinds(before(12.0, at(0, 0, {2, 2}, 90.0))), Contains(CueKind::obstacle)) << "another one";
}

TEST_F(GuideTest, WhoAsksAgainAfterTheyHaveTurnedHearsWhatIsNext) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  EXPECT_THAT(kinds(wearer.stand(2.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::turn));
  (void)wearer.stand(0.6, 0, {1, 2.5}, 0.0);
  EXPECT_TRUE(guide.repeat());
  const auto cues = kinds(wearer.stand(2.0, 0, {1, 2.5}, 0.0));
  EXPECT_THAT(cues, Contains(CueKind::go_straight));
  EXPECT_THAT(cues, Not(Contains(CueKind::turn))) << "it would lead them away";
}

TEST_F(GuideTest, WhoAsksForTheWayWhenThePlaceIsLostHearsSo) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  EXPECT_THAT(kinds(wearer.stand(4.0, 0, {1, 2.5}, 90.0)), Contains(CueKind::turn));
  EXPECT_TRUE(guide.repeat());
  const auto cues = kinds(wearer.stay(12.0, lost(0)));
  EXPECT_THAT(cues, Contains(CueKind::uncertain));
  EXPECT_THAT(cues, Not(Contains(CueKind::turn)));
}

TEST_F(GuideTest, WhoStandsInACornerIsNotLeftInSilence) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  for (const double heading : {225.0, 180.0, 0.0}) {
    const auto cues = wearer.stand(25.0, 0, {0.27, 0.27}, heading);
    EXPECT_TRUE(std::any_of(cues.begin(), cues.end(), [](const Cue& c) {
      return c.kind == CueKind::turn || c.kind == CueKind::go_straight || c.kind == CueKind::bear || c.tail.present;
    })) << heading;
  }
}

TEST(Guide, WhatIsHeardBesideTheWearerIsLedRoundWhenTheyTurnThere) {
  const Building hall = test::make_grid(1, 1, 8.0);
  const auto first_turn = [&](double beside) {
    Listener wearer(hall);
    const Estimate here = at(0, 0, {4, 4}, 0.0);
    (void)wearer.hear(4.0, here, [&](double bearing) {
      return std::abs(bearing - kPi / 2) < degrees(15.0) ? beside : Firing::kNoEcho;
    });
    EXPECT_TRUE(wearer.guide.set_destination({Goal::Kind::spot, 0, {0, {4, 7}}}));
    const auto cues = wearer.hear(4.0, here, [](double) { return Firing::kNoEcho; });
    const auto turn = std::find_if(cues.begin(), cues.end(), [](const Cue& c) { return c.kind == CueKind::turn; });
    return turn == cues.end() ? 0.0 : turn->direction;
  };
  EXPECT_EQ(sector_of(first_turn(Firing::kNoEcho)), Sector::left);
  EXPECT_NE(sector_of(first_turn(0.5)), Sector::left) << "a cupboard stands there";
}

TEST_F(GuideTest, WarnsOfASteadyThingThatNoPlanKnows) {
  (void)wearer.stand(3.0, 0, {1, 1.0}, 0.0);
  const auto cues = wearer.scan({0.9, 0.9, 0.9, 0.9}, at(0, 0, {1, 1.0}, 0.0));
  ASSERT_THAT(kinds(cues), ElementsAre(CueKind::obstacle));
  EXPECT_NEAR(cues[0].distance_m, 0.9, 0.05);
  EXPECT_EQ(sector_of(cues[0].direction), Sector::ahead);
  EXPECT_NEAR(guide.obstacle_ahead_m(), 0.9, 0.05);
  (void)wearer.stand(5.0, 0, {1, 1.0}, 0.0);
  EXPECT_LT(guide.obstacle_ahead_m(), 0.0) << "it answers no more";
}

TEST_F(GuideTest, LeadsRoundASteadyThingThatNoPlanKnows) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {0, {4, 1.0}}}));
  (void)wearer.stand(5.0, 0, {1, 1.0}, 0.0);
  (void)wearer.scan({0.9, 0.9, 0.9, 0.9}, at(0, 0, {1, 1.0}, 0.0));
  const auto cues = wearer.stand(12.0, 0, {1, 1.0}, 0.0);
  const auto turn = std::find_if(cues.begin(), cues.end(), [](const Cue& c) { return c.kind == CueKind::turn; });
  ASSERT_NE(turn, cues.end());
  EXPECT_GT(turn->direction, 0.0);  // to the left: on the right there is but a metre between thing and wall
}

TEST_F(GuideTest, LeadsRoundWhatStoppedTheWearerUnseen) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {0, {4.3, 1.0}}}));
  EXPECT_THAT(kinds(wearer.stand(6.0, 0, {0.7, 1.0}, 0.0)), Contains(CueKind::go_straight));
  Estimate walking = at(0, 0, {0.7, 1.0}, 0.0);
  walking.speed_mps = 0.8;
  for (const double end = wearer.now + 1.5; wearer.now < end; walking.pose.position.x += 0.8 * kSlot) {
    (void)wearer.stay(kSlot, walking);
  }
  // Stands well short of where the way goes, and nobody said stop.
  const auto cues = wearer.stand(8.0, 0, walking.pose.position, 0.0);
  EXPECT_THAT(kinds(cues), Contains(CueKind::turn));
}

TEST_F(GuideTest, WhoWalkedMeanwhileHasMissedTwoLinesAndMetNothing) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {0, {4.3, 1.0}}}));
  EXPECT_THAT(kinds(wearer.stand(8.0, 0, {0.7, 1.0}, 0.0)), Contains(CueKind::go_straight));
  Estimate walking = at(0, 0, {0.7, 1.0}, 0.0);
  walking.speed_mps = 0.6;
  for (const double end = wearer.now + 1.0; wearer.now < end; walking.pose.position.x += 0.6 * kSlot) {
    (void)wearer.stay(kSlot, walking);
  }
  const auto cues = kinds(wearer.stand(14.0, 0, walking.pose.position, 0.0));
  EXPECT_THAT(cues, Contains(CueKind::go_straight));
  EXPECT_THAT(cues, Not(Contains(CueKind::turn))) << "round what is not there";
}

TEST_F(GuideTest, IsNotAlarmedByWallsOrByASingleFalseEcho) {
  (void)wearer.stand(3.0, 0, {1, 1.0}, 0.0);
  EXPECT_THAT(wearer.scan({3.85, 3.85, 0.9, 3.85, 3.85, 3.85}, at(0, 0, {1, 1.0}, 0.0)), IsEmpty());
}

TEST_F(GuideTest, TellsOfTheBeltOnceEach) {
  BeltHealth health;
  health.sensor_count = 15;
  const auto tell = [&](double now) { guide.on_belt_health(health, now); };
  health.link = BeltLink::connected;
  tell(0.0);
  health.link = BeltLink::lost;
  tell(5.0);
  tell(6.0);
  health.link = BeltLink::connected;
  tell(9.0);
  health.sensors[2].state = SensorState::silent;
  tell(12.0);
  tell(30.0);
  health.has_battery = true;
  health.battery_v = 5.0;
  tell(40.0);
  tell(60.0);
  EXPECT_THAT(kinds(wearer.fetch()), ElementsAre(CueKind::belt_back, CueKind::belt_lost, CueKind::belt_back,
                                                 CueKind::sensor_blocked, CueKind::battery_low));
}

TEST_F(GuideTest, LeadsBackTheWayTheWearerCame) {
  (void)wearer.stand(2.0, 0, {1, 1}, 0.0);
  for (const Vec2 on_the_way : {Vec2{2, 2}, {2.5, 2.5}, {3.5, 2.5}, {4.5, 2.5}}) {
    (void)wearer.stand(1.0, 0, on_the_way, 0.0);
  }
  for (const Vec2 beyond : {Vec2{0.3, 2.5}, {1, 2.5}}) (void)wearer.stand(1.0, 1, beyond, 0.0);
  ASSERT_TRUE(guide.back_track());
  (void)wearer.stand(1.0, 1, {1.6, 2.5}, 0.0);
  const Route& route = guide.route();
  ASSERT_FALSE(route.waypoints.empty());
  EXPECT_EQ(route.waypoints.back().room, 0);
  EXPECT_NEAR(distance(route.waypoints.back().at, Vec2{1, 1}), 0.0, 1e-9);
}

TEST_F(GuideTest, AfterARestartTheDestinationStaysAndIsToldFromTheNewPlace) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(4.0, 0, {1, 2.5}, 0.0);
  ASSERT_FALSE(guide.breadcrumbs().empty());
  guide.on_start(kTold);
  EXPECT_TRUE(guide.has_destination());
  EXPECT_TRUE(guide.route().waypoints.empty()) << "the old way leads from where the wearer is not";
  EXPECT_TRUE(guide.breadcrumbs().empty());
  EXPECT_FALSE(guide.repeat()) << "the old instruction was for another place";
  const auto cues = wearer.stand(12.0, 1, {1, 1}, -90.0);
  EXPECT_THAT(kinds(cues), Contains(CueKind::turn));
  ASSERT_FALSE(guide.breadcrumbs().empty());
  EXPECT_EQ(guide.breadcrumbs().front().room, 1);
  EXPECT_EQ(guide.route().waypoints.front().room, 1);
}

TEST_F(GuideTest, AfterARestartThereIsNoWayBackToWhereTheWearerNeverWas) {
  (void)wearer.stand(1.0, 0, {1, 1}, 0.0);
  (void)wearer.stand(1.0, 0, {2.5, 2.5}, 0.0);
  ASSERT_TRUE(guide.back_track());
  guide.on_start(kTold);
  EXPECT_FALSE(guide.has_destination());
  EXPECT_FALSE(guide.back_track());
}

TEST_F(GuideTest, AfterARestartTheRoomIsNamedAgain) {
  ASSERT_THAT(kinds(wearer.stand(12.0, 0, {2, 2}, 0.0)), ElementsAre(CueKind::entering));
  guide.on_start(kTold);
  EXPECT_THAT(kinds(wearer.stand(5.0, 0, {2, 2}, 0.0)), Contains(CueKind::entering));
}

TEST_F(GuideTest, SurvivesNonsense) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  guide.on_estimate(at(nan, 0, {1, 1}, 0));
  Estimate e = at(1.0, 99, {nan, 1}, nan);
  for (int i = 0; i < 200; ++i) {
    e.time_s += 0.1;
    e.room = i % 3 == 0 ? 0 : 99;
    e.speed_mps = nan;
    e.sigma_m = nan;
    guide.on_estimate(e);
    guide.on_firing({e.time_s, i % 20 - 2, nan});
  }
  guide.on_belt_health({}, nan);
  wearer.now = 30.0;
  for (const RoomIndex room : {99, 0}) {
    for (const Cue& cue : wearer.stand(4.0, room, {1, 1}, 0.0)) {
      EXPECT_TRUE(std::isfinite(cue.direction));
      EXPECT_TRUE(std::isfinite(cue.distance_m));
    }
  }
}

TEST_F(GuideTest, DoubtsAPlaceThatNobodyToldWhereTheWearerGetsNowhere) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stay(5.0, lost(0));
  (void)wearer.turn_about(10.0, 0, {1, 2.5});
  (void)wearer.stand(15.0, 0, {1, 2.5}, 0.0);
  EXPECT_FALSE(guide.take_doubt()) << "they have hardly been told";
  // Sent on again and again, they stay where they are.
  (void)wearer.stand(120.0, 0, {1, 2.5}, 0.0);
  EXPECT_TRUE(guide.take_doubt());
  EXPECT_FALSE(guide.take_doubt()) << "once is enough";
}

/// Nobody told where they start; the tracker finds them at `position` by their slow turn. They face along the x axis.
void find_by_a_turn(Listener& wearer, RoomIndex room, Vec2 position) {
  (void)wearer.stay(4.0, lost(0));
  (void)wearer.turn_about(9.0, room, position);
  (void)wearer.stand(0.5, room, position, 0.0);
}

TEST_F(GuideTest, WhoIsFoundAtTheirDestinationIsToldSoOnceThePlaceHasStoodADoubt) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stay(4.0, lost(0));
  EXPECT_THAT(kinds(wearer.turn_about(5.0, 1, {3.5, 4.0})), Not(Contains(CueKind::arrived)))
      << "it may be a room like this one";
  EXPECT_TRUE(guide.take_doubt());
  EXPECT_THAT(kinds(wearer.stand(8.0, 1, {3.5, 4.0}, 0.0)), Contains(CueKind::arrived));
  EXPECT_FALSE(guide.take_doubt()) << "once is enough";
}

TEST_F(GuideTest, WhoIsFoundElsewhereByTheDoubtIsLedOn) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  find_by_a_turn(wearer, 1, {3.5, 4.0});
  ASSERT_TRUE(guide.take_doubt());
  auto cues = kinds(wearer.turn_about(12.0, 3, {3.5, 4.0}));
  for (const CueKind kind : kinds(wearer.stand(8.0, 3, {3.5, 4.0}, 0.0))) cues.push_back(kind);
  EXPECT_THAT(cues, Not(Contains(CueKind::arrived)));
  EXPECT_THAT(cues, Contains(CueKind::turn));
}

TEST_F(GuideTest, WhoHasLeftTheRoomWhereTheyWereFoundIsToldThatTheyAreThereWithoutADoubt) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  find_by_a_turn(wearer, 0, {3.0, 2.5});
  Estimate walking = at(0, 0, {3.0, 2.5}, 0.0);
  walking.speed_mps = 0.8;
  std::vector<CueKind> told;
  const auto step = [&] {
    for (const Cue& cue : wearer.step(walking)) told.push_back(cue.kind);
  };
  while (walking.pose.position.x < 5.0) step();
  walking.room = 1;
  walking.pose.position.x = 0.0;
  while (walking.pose.position.x < 3.5) step();
  walking.pose.heading = degrees(90.0);
  while (walking.pose.position.y < 3.6) step();
  for (const Cue& cue : wearer.stand(3.0, 1, walking.pose.position, 90.0)) told.push_back(cue.kind);
  EXPECT_THAT(told, Contains(CueKind::arrived));
  EXPECT_FALSE(guide.take_doubt());
}

TEST_F(GuideTest, DoubtsAPlaceThatNobodyToldWhereAWallIsMetInsteadOfTheDoor) {
  ASSERT_TRUE(guide.set_destination({Goal::Kind::spot, 0, {1, {3, 2.5}}}));
  find_by_a_turn(wearer, 0, {4.0, 2.5});
  ASSERT_THAT(kinds(wearer.stand(8.0, 0, {4.0, 2.5}, 8.0)), Contains(CueKind::go_straight));
  Estimate walking = at(0, 0, {4.0, 2.5}, 8.0);
  walking.speed_mps = 0.6;
  for (const double end = wearer.now + 1.1; wearer.now < end;) (void)wearer.step(walking);
  EXPECT_FALSE(guide.take_doubt());
  (void)wearer.stand(6.0, 0, walking.pose.position, 8.0);
  EXPECT_TRUE(guide.take_doubt());
}

TEST_F(GuideTest, DoesNotDoubtAPlaceThatTheWearerTold) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stand(150.0, 0, {1, 2.5}, 0.0);
  EXPECT_FALSE(guide.take_doubt()) << "something stands in their way";
}

TEST_F(GuideTest, DoubtsAPlaceThatTheWearerToldWithoutTheWayTheyFace) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  guide.on_start({0, Vec2{1, 2.5}, {}});
  (void)wearer.turn_about(10.0, 0, {1, 2.5});
  (void)wearer.stand(150.0, 0, {1, 2.5}, 0.0);
  EXPECT_TRUE(guide.take_doubt());
}

TEST_F(GuideTest, AfterARestartThePlaceIsDoubtedByTheNewStartAlone) {
  ASSERT_TRUE(guide.set_destination("Lectern"));
  (void)wearer.stay(5.0, lost(0));
  (void)wearer.turn_about(10.0, 0, {1, 2.5});
  guide.on_start(kTold);
  (void)wearer.stand(150.0, 0, {1, 2.5}, 0.0);
  EXPECT_FALSE(guide.take_doubt()) << "now they said where they are";
}

TEST(Guide, SendsTheWearerUpTheStairsAndTellsTheTracker) {
  const Building b = two_levels(6);
  Listener wearer(b);
  ASSERT_TRUE(wearer.guide.set_destination("Desk"));
  EXPECT_THAT(kinds(wearer.stand(5.0, 0, {2, 2}, 0.0)), Not(Contains(CueKind::take_link)));
  const auto cues = wearer.stand(3.0, 0, {4.6, 2}, 0.0);
  const auto take = std::find_if(cues.begin(), cues.end(), [](const Cue& c) { return c.kind == CueKind::take_link; });
  ASSERT_NE(take, cues.end());
  EXPECT_TRUE(take->up);
  const auto transition = wearer.guide.take_level_transition();
  ASSERT_TRUE(transition);
  EXPECT_EQ(transition->to, 1);
  EXPECT_FALSE(wearer.guide.take_level_transition());
  // On the stairs echoes fit nowhere; that is no loss.
  EXPECT_THAT(wearer.stay(10.0, lost(0)), IsEmpty());
  EXPECT_THAT(kinds(wearer.stand(6.0, 1, {5, 2}, 180.0)), Contains(CueKind::go_straight));
  const auto over = wearer.guide.take_level_transition();
  ASSERT_TRUE(over);
  EXPECT_EQ(over->to, 1);
  EXPECT_EQ(over->patience_s, 0.0) << "they walk on from there";
}

/// Somebody who has just been told to take the stairs.
class OnStairsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(wearer.guide.set_destination("Desk"));
    ASSERT_THAT(kinds(wearer.stand(8.0, 0, {4.6, 2}, 0.0)), Contains(CueKind::take_link));
    ASSERT_TRUE(wearer.guide.take_level_transition());
  }
  const Building building = two_levels(6);
  Listener wearer{building};
};

TEST_F(OnStairsTest, WhoMissedItIsToldAgain) {
  ASSERT_TRUE(wearer.guide.repeat());
  EXPECT_THAT(kinds(wearer.stand(3.0, 0, {4.6, 2}, 0.0)), Contains(CueKind::take_link));
}

TEST_F(OnStairsTest, WhoAsksOnceTheyMustBeOutIsLookedForAndNotSentUpAgain) {
  Estimate between = lost(0);
  between.state = TrackState::searching;
  EXPECT_THAT(wearer.stay(16.0, between), IsEmpty());
  ASSERT_TRUE(wearer.guide.repeat());
  const auto cues = kinds(wearer.stay(4.0, between));
  EXPECT_THAT(cues, Contains(CueKind::uncertain));
  EXPECT_THAT(cues, Not(Contains(CueKind::take_link)));
  EXPECT_TRUE(wearer.guide.take_doubt()) << "they are out, and still taken to be on the level that they left";
}

TEST_F(OnStairsTest, WhoAsksAndIsFoundOnAnotherLevelIsNotDoubted) {
  Estimate above = at(1, 1, {1, 2}, 0.0);
  above.state = TrackState::searching;
  above.room_probability = 0.4;
  (void)wearer.stay(16.0, lost(0));
  ASSERT_TRUE(wearer.guide.repeat());
  (void)wearer.stay(1.0, above);
  EXPECT_FALSE(wearer.guide.take_doubt());
}

TEST_F(OnStairsTest, WhoAsksAgainAndAgainFindsNoStairsAndIsNotWhereTheyAreThoughtToBe) {
  (void)wearer.stand(16.0, 0, {4.6, 2}, 0.0);
  ASSERT_TRUE(wearer.guide.repeat());
  EXPECT_THAT(kinds(wearer.stand(8.0, 0, {4.6, 2}, 0.0)), Contains(CueKind::take_link));
  EXPECT_FALSE(wearer.guide.take_doubt());
  ASSERT_TRUE(wearer.guide.repeat());
  EXPECT_THAT(kinds(wearer.stand(8.0, 0, {4.6, 2}, 0.0)), Contains(CueKind::uncertain));
  EXPECT_TRUE(wearer.guide.take_doubt());
}

TEST(Guide, NobodyIsToldToTurnOnStairsThatTheyTookUnasked) {
  const Building b = two_levels(6);
  Listener wearer(b);
  (void)wearer.stand(4.0, 0, {4.6, 2}, 0.0);
  EXPECT_THAT(wearer.stay(20.0, lost(0)), IsEmpty());
  EXPECT_THAT(kinds(wearer.stand(2.0, 1, {5, 2}, 180.0)), Contains(CueKind::entering));
  // Away from the stairs it is a loss like any other.
  (void)wearer.stand(2.0, 1, {1, 2}, 180.0);
  EXPECT_THAT(kinds(wearer.stay(4.0, lost(0))), Contains(CueKind::uncertain));
}

TEST(Guide, ATurnIntoAWallWaitsUntilTheWearerStands) {
  // Along the wall of a corridor, 0.4 m off it, to a door in that wall: a moment too late and the turn faces the wall.
  Building b;
  b.rooms.push_back(test::make_box("hall", 12, 2));
  b.rooms.push_back(test::make_box("office", 4, 4));
  test::add_door(b, 0, {8, 2}, 1, {2, 0});
  Listener wearer(b);
  ASSERT_TRUE(wearer.guide.set_destination({Goal::Kind::spot, 0, {1, {2, 3}}}));
  Estimate walking = at(0, 0, {4.0, 1.6}, 0.0);
  walking.speed_mps = 0.9;
  std::vector<CueKind> said;
  while (walking.pose.position.x < 7.8) {
    for (const Cue& cue : wearer.stay(kSlot, walking)) said.push_back(cue.kind);
    walking.pose.position.x += 0.9 * kSlot;
  }
  EXPECT_THAT(said, Contains(CueKind::stop));
  EXPECT_THAT(said, Not(Contains(CueKind::turn)));
}

TEST(Guide, WhoWantsToBeWhereTheyAreHasArrivedThoughNothingLeadsThere) {
  Building b = test::make_grid(2, 1);
  b.doors.clear();
  Listener wearer(b);
  const Goal room{Goal::Kind::room, 1, {}};
  EXPECT_FALSE(wearer.guide.set_destination(room, {}, 0));
  ASSERT_TRUE(wearer.guide.set_destination(room, {}, 1));
  EXPECT_THAT(kinds(wearer.stand(5.0, 1, {2, 2}, 0.0)), Contains(CueKind::arrived));
}

TEST(Guide, SaysWhenNoWayLeadsThere) {
  Building b = test::make_grid(3, 1);
  b.doors.erase(b.doors.begin());
  Listener wearer(b);
  ASSERT_TRUE(wearer.guide.set_destination({Goal::Kind::spot, 0, {1, {2, 2}}}));
  EXPECT_THAT(kinds(wearer.stand(5.0, 0, {2, 2}, 0.0)), Contains(CueKind::no_way));
}

}  // namespace
}  // namespace echoway
