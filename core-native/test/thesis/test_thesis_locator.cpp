#include "echoway/thesis/thesis_locator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "echoway/random.hpp"
#include "echoway/sim/simulate.hpp"
#include "support/rooms.hpp"

namespace echoway {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Building one_room(Room room) {
  Building building;
  building.rooms.push_back(std::move(room));
  return building;
}

// A room with a pier and the thesis's sample room side by side, a door between them.
Building two_rooms() {
  Building building;
  building.rooms = {rooms::with_pier(), rooms::sample_room()};
  building.rooms[0].id = "A";
  building.rooms[1].id = "B";
  building.rooms[1].frame = {{6.0, -1.6}, 0.0};
  building.doors = {{0, {6.0, 2.6}, 1, {0.0, 4.2}, 0.9}};
  return building;
}

// The firings of one scan by a wearer who stands still in the simulated world, which shares no acoustics with the core.
std::vector<Firing> stand(const Building& building, RoomIndex room, const Pose2& pose, double from_s,
                          std::uint64_t seed, const BeltConfig& belt = {}) {
  sim::Walk walk;
  walk.seed = seed;
  walk.start = {building.room(room).id, pose.position};
  walk.start_heading = pose.heading;
  walk.steps.push_back({sim::Pause{2.0 * belt.sensors * belt.slot_s + 0.2}});
  walk.world = sim::make_world(sim::Profile::empty);
  walk.belt = belt;
  const auto simulation = sim::simulate(building, walk);
  EXPECT_TRUE(simulation.ok()) << (simulation.ok() ? "" : simulation.error().to_string());
  std::vector<Firing> firings = simulation->scans.firings;
  firings.resize(std::min(firings.size(), static_cast<std::size_t>(2 * belt.sensors)));
  for (Firing& f : firings) f.time_s += from_s;
  return firings;
}

std::unique_ptr<Locator> locator(const Building& building, const Start& start, const BeltConfig& belt = {}) {
  auto made = make_thesis_locator(building, belt, start);
  EXPECT_TRUE(made.ok());
  return std::move(made.value());
}

int feed(Locator& locator, const std::vector<Firing>& firings) {
  int renewed = 0;
  for (const Firing& f : firings) renewed += locator.on_firing(f) ? 1 : 0;
  return renewed;
}

TEST(ThesisLocator, FollowsTheThesissCircularWalk) {
  // Section 6.2.2: in a 19 x 22 ft room, a foot and ten degrees between one scan and the next.
  const Building building = one_room(rooms::sample_room());
  const Vec2 centre{feet(11.5), feet(11.0)};
  const auto checkpoint = [&](int i) {
    const double angle = degrees(10.0) * i;
    return Pose2{centre + feet(5.7) * unit_from_angle(angle), wrap_angle(angle + kPi / 2.0)};
  };
  const auto walker = locator(building, {0, checkpoint(0).position, checkpoint(0).heading});
  double sum = 0.0;
  for (int i = 0; i < 36; ++i) {
    const auto firings = stand(building, 0, checkpoint(i), 2.5 * i, 100 + static_cast<std::uint64_t>(i));
    EXPECT_EQ(feed(*walker, firings), 1) << i;
    const double error = distance(walker->estimate().pose.position, checkpoint(i).position);
    EXPECT_LT(error, feet(4.0)) << i;
    sum += error;
  }
  EXPECT_LT(sum / 36.0, feet(1.0));
  EXPECT_EQ(walker->estimate().state, TrackState::tracking);
}

TEST(ThesisLocator, GoesThroughADoor) {
  const Building building = two_rooms();
  const auto walker = locator(building, {0, Vec2{3.9, 2.6}, 0.2});
  double time = 0.0;
  std::uint64_t seed = 1;
  const auto stop = [&](RoomIndex room, Vec2 at) {
    feed(*walker, stand(building, room, {at, 0.2}, time, seed++));
    time += 2.5;
  };
  for (double x = 3.9; x < 5.9; x += 0.3) stop(0, {x, 2.6});
  for (double x = 0.3; x < 3.2; x += 0.3) stop(1, {x, 4.2});
  EXPECT_EQ(walker->estimate().room, 1);
  EXPECT_LT(distance(walker->estimate().pose.position, {3.0, 4.2}), 0.6);
}

TEST(ThesisLocator, FindsTheWearerWithoutAStart) {
  const Building building = one_room(rooms::with_pier());
  const auto walker = locator(building, {});
  EXPECT_EQ(walker->estimate().room, kNoRoom);
  const Pose2 truth{{4.2, 1.7}, degrees(65.0)};
  bool tracked = false;
  for (int i = 0; i < 12; ++i) {
    // Turning on the spot shows each sensor something else.
    const Pose2 pose{truth.position, truth.heading + degrees(8.0) * i};
    feed(*walker, stand(building, 0, pose, 2.5 * i, 40 + static_cast<std::uint64_t>(i)));
    tracked = tracked || walker->estimate().state == TrackState::tracking;
  }
  EXPECT_TRUE(tracked);
  EXPECT_LT(distance(walker->estimate().pose.position, truth.position), 0.5);
}

TEST(ThesisLocator, SaysThatItIsSearchingWhileTwoPlacesLookAlike) {
  // A bare rectangle looks the same after half a turn, whatever the echoes.
  const Building building = one_room(rooms::rectangle(5.0, 3.5));
  const auto walker = locator(building, {});
  for (int i = 0; i < 8; ++i) {
    feed(*walker, stand(building, 0, {{1.6, 1.2}, 0.4}, 2.5 * i, 7 + static_cast<std::uint64_t>(i)));
  }
  EXPECT_EQ(walker->estimate().state, TrackState::searching);
  EXPECT_GE(walker->hypotheses().size(), 2U);
  double total = 0.0;
  for (const Hypothesis& h : walker->hypotheses()) total += h.probability;
  EXPECT_LE(total, 1.0 + 1e-9);
}

TEST(ThesisLocator, RenewsItsEstimateOncePerTwoPasses) {
  const Building building = one_room(rooms::sample_room());
  const auto walker = locator(building, {0, Vec2{3.5, 3.0}, 0.0});
  int renewed = 0;
  for (int i = 0; i < 150; ++i) {
    const bool now = walker->on_firing({0.0624 * i, i % 15, 2.0});
    EXPECT_EQ(now, i % 30 == 29);
    renewed += now ? 1 : 0;
  }
  EXPECT_EQ(renewed, 5);
}

TEST(ThesisLocator, GetsByWithoutSomeSensors) {
  const Building building = one_room(rooms::sample_room());
  const Pose2 truth{{3.6, 3.1}, degrees(40.0)};
  const auto walker = locator(building, {0, truth.position + Vec2{0.2, 0.2}, truth.heading});
  for (int i = 0; i < 4; ++i) {
    auto firings = stand(building, 0, truth, 2.5 * i, 60 + static_cast<std::uint64_t>(i));
    std::erase_if(firings, [](const Firing& f) { return f.sensor == 2 || f.sensor == 9 || f.sensor == 12; });
    feed(*walker, firings);
  }
  EXPECT_LT(distance(walker->estimate().pose.position, truth.position), 0.6);
}

TEST(ThesisLocator, SaysThatItIsLostWhenNothingAnswers) {
  const Building building = one_room(rooms::sample_room());
  const Vec2 start{3.5, 3.0};
  const auto walker = locator(building, {0, start, 0.0});
  double sigma = walker->estimate().sigma_m;
  for (int i = 0; i < 60 * 150; ++i) walker->on_firing({0.0624 * i, i % 15, Firing::kNoEcho});
  EXPECT_EQ(walker->estimate().state, TrackState::lost);
  EXPECT_EQ(walker->estimate().pose.position, start);
  EXPECT_GT(walker->estimate().sigma_m, sigma);
  EXPECT_TRUE(std::isfinite(walker->estimate().sigma_m));
}

TEST(ThesisLocator, AdmitsThatAHallHidesWhereAlongItTheWearerIs) {
  // A wide beam hears each long wall with several sensors, and nothing of the ends, which are out of range. By hand:
  // the north wall is 1.3 m and the south wall 1.1 m off the axis, less the face's share of the 0.15 m.
  const Building building = one_room(rooms::rectangle(60.0, 2.4));
  BeltConfig belt;
  belt.beam_rad = degrees(70.0);
  const auto reading = [&](int sensor) {
    const double across = std::sin(0.1 + belt.bearing(sensor));
    if (std::abs(across) < std::cos(degrees(34.0))) return Firing::kNoEcho;
    return (across > 0.0 ? 1.3 : 1.1) - 0.15 * std::abs(across);
  };
  const auto walker = locator(building, {0, Vec2{30.0, 1.1}, 0.1}, belt);
  for (int i = 0; i < 150; ++i) walker->on_firing({0.0624 * i, i % 15, reading(i % 15)});
  const Estimate& e = walker->estimate();
  EXPECT_EQ(e.state, TrackState::tracking);
  EXPECT_NEAR(e.pose.position.y, 1.1, 0.05);
  EXPECT_GT(e.covariance_xx, 20.0 * e.covariance_yy);
  EXPECT_GT(e.sigma_m, 1.0);
}

TEST(ThesisLocator, CorrectsRangesForTheTemperature) {
  const Building building = one_room(rooms::sample_room());
  const auto walker = locator(building, {0, Vec2{3.5, 3.0}, 0.0});
  walker->on_temperature(35.0);
  walker->on_temperature(kNan);
  walker->on_temperature(-200.0);
  for (int i = 0; i < 30; ++i) walker->on_firing({0.0624 * i, i % 15, 2.0});
  EXPECT_NEAR(walker->estimate().sound_speed_scale, speed_of_sound(35.0) / speed_of_sound(20.0), 1e-12);
}

TEST(ThesisLocator, IgnoresFiringsThatMakeNoSense) {
  const Building building = one_room(rooms::sample_room());
  const auto walker = locator(building, {0, Vec2{3.5, 3.0}, 0.0});
  EXPECT_FALSE(walker->on_firing({0.0, -1, 2.0}));
  EXPECT_FALSE(walker->on_firing({0.0, 15, 2.0}));
  EXPECT_FALSE(walker->on_firing({kNan, 0, 2.0}));
  EXPECT_FALSE(walker->on_firing({0.0, 0, kNan}));
}

TEST(ThesisLocator, GoesOnAfterTheClockWasSetBack) {
  const Building building = one_room(rooms::sample_room());
  const auto walker = locator(building, {0, Vec2{3.5, 3.0}, 0.0});
  for (int i = 0; i < 40; ++i) walker->on_firing({1000.0 + 0.0624 * i, i % 15, 2.0});
  int renewed = 0;
  for (int i = 0; i < 100; ++i) renewed += walker->on_firing({5.0 + 0.0624 * i, i % 15, 2.0}) ? 1 : 0;
  EXPECT_GE(renewed, 2);
}

TEST(ThesisLocator, StandsRandomFiringsOfAnyBelt) {
  const Building building = two_rooms();
  for (const int sensors : {1, 3, 15, 64}) {
    BeltConfig belt;
    belt.sensors = sensors;
    for (const Start& start :
         {Start{}, Start{0, Vec2{1.0, 1.0}, 0.3}, Start{1, {}, {}}, Start{0, Vec2{-0.9, 0.0}, 0.0}}) {
      const auto walker = locator(building, start, belt);
      Random random(static_cast<std::uint64_t>(sensors));
      double time = 0.0;
      for (int i = 0; i < 8 * sensors; ++i) {
        time += random.uniform(-0.01, 0.2);
        const double range = random.uniform() < 0.3 ? Firing::kNoEcho : random.uniform(0.0, 12.0);
        walker->on_firing({time, static_cast<int>(random.uniform(-1.0, sensors + 1.0)), range});
        const Estimate& e = walker->estimate();
        ASSERT_TRUE(is_finite(e.pose));
        ASSERT_TRUE(std::isfinite(e.sigma_m) && std::isfinite(e.sigma_heading_rad) && std::isfinite(e.speed_mps));
        ASSERT_TRUE(e.room_probability >= 0.0 && e.room_probability <= 1.0);
      }
    }
  }
}

TEST(ThesisLocator, GivesTheSameAnswerOnEveryRun) {
  const Building building = one_room(rooms::sample_room());
  const auto firings = stand(building, 0, {{3.6, 3.1}, 0.7}, 0.0, 3);
  const auto a = locator(building, {});
  const auto b = locator(building, {});
  feed(*a, firings);
  feed(*b, firings);
  EXPECT_EQ(a->estimate().pose, b->estimate().pose);
  EXPECT_EQ(a->estimate().sigma_m, b->estimate().sigma_m);
}

TEST(ThesisLocator, RefusesABeltOrAStartThatMakesNoSense) {
  const Building building = two_rooms();
  BeltConfig belt;
  belt.sensors = 65;
  EXPECT_FALSE(make_thesis_locator(building, belt, {}).ok());
  belt = {};
  belt.radius_m = kNan;
  EXPECT_FALSE(make_thesis_locator(building, belt, {}).ok());
  EXPECT_FALSE(make_thesis_locator(building, {}, {2, {}, {}}).ok());
  EXPECT_FALSE(make_thesis_locator(building, {}, {{}, Vec2{1.0, 1.0}, {}}).ok());
  EXPECT_FALSE(make_thesis_locator(building, {}, {0, Vec2{kNan, 1.0}, {}}).ok());
  EXPECT_FALSE(make_thesis_locator(Building{}, {}, {}).ok());
}

}  // namespace
}  // namespace echoway
