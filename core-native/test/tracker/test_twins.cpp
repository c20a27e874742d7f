// Rooms that look the same turned about: a search that has found the wrong place of two has found the right one too.
#include "tracker/twins.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/echo_model.hpp"
#include "tracker/likelihood.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"

namespace echoway::tracker {
namespace {

constexpr Vec2 kPlace{1.0, 0.8};
constexpr double kHeading = 0.3;

Particle somebody_at(Vec2 position) {
  Particle p;
  p.room = 0;
  p.position = position;
  p.heading = kHeading;
  p.facing = unit_from_angle(kHeading);
  p.speed = 0.4;
  p.cov = {.xx = 0.02, .xy = 0.005, .xs = 0.003, .xk = 1e-5,
           .yy = 0.01, .ys = -0.002, .yk = -2e-5, .ss = 0.02, .kk = 1e-4};
  return p;
}

Population found_at(Vec2 position) {
  constexpr std::size_t kFound = 100;
  Population population(2 * kFound);
  for (std::size_t i = 0; i < kFound; ++i) {
    Particle p = somebody_at(position);
    p.weight = 1.0 / kFound;
    population.push(p);
  }
  return population;
}

Building room_of(std::vector<Vec2> outline) {
  Building b;
  b.rooms.push_back(test::room_from_outline("room", std::move(outline)));
  return b;
}

double weight_of(const Population& population, Vec2 position, double heading) {
  double weight = 0.0;
  for (const Particle& p : population.particles()) {
    const bool there = distance(p.position, position) < 1e-9 && std::abs(wrap_angle(p.heading - heading)) < 1e-9;
    weight += there ? p.weight : 0.0;
  }
  return weight;
}

class TwinsTest : public ::testing::Test {
 protected:
  Population with_twins(const Building& building) const {
    const scene::Scene scene(building, model_.sight_limits());
    Population population = found_at(kPlace);
    add_twins(population, scene);
    return population;
  }
  EchoModel model_{BeltConfig{}, EchoModelParameters{}};
};

TEST_F(TwinsTest, APlaceInARectangularRoomHasOneByHalfATurn) {
  const Population population = with_twins(test::plain_hall());
  const double twin = weight_of(population, test::kFarCorner - kPlace, kHeading + kPi);
  EXPECT_NEAR(twin / weight_of(population, kPlace, kHeading), 0.1, 1e-9);
  EXPECT_NEAR(twin + weight_of(population, kPlace, kHeading), 1.0, 1e-9) << "and there are no others";
}

TEST_F(TwinsTest, APlaceInASquareRoomHasThree) {
  const Population population = with_twins(room_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  const double found = weight_of(population, kPlace, kHeading);
  EXPECT_NEAR(weight_of(population, {4 - kPlace.y, kPlace.x}, kHeading + 0.5 * kPi) / found, 0.1 / 3.0, 1e-9);
  EXPECT_NEAR(weight_of(population, {4 - kPlace.x, 4 - kPlace.y}, kHeading + kPi) / found, 0.1 / 3.0, 1e-9);
  EXPECT_NEAR(weight_of(population, {kPlace.y, 4 - kPlace.x}, kHeading - 0.5 * kPi) / found, 0.1 / 3.0, 1e-9);
}

TEST_F(TwinsTest, NobodyStandsOutsideTheRoom) {
  const Population population = with_twins(room_of({{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 4}, {0, 4}}));
  EXPECT_NEAR(weight_of(population, kPlace, kHeading), 1.0, 1e-9);
}

TEST_F(TwinsTest, NothingThatTheBeltHearsTellsThemApartInAnEmptyRoom) {
  const Building hall = test::plain_hall();
  scene::Scene scene(hall, model_.sight_limits());
  Population population = found_at(kPlace);
  add_twins(population, scene);
  Particle found = population.particles().front();
  Particle twin = population.particles().back();
  const BeltConfig belt;
  for (int sensor = 0; sensor < belt.sensors; ++sensor) {
    Record record;
    record.sensor = sensor;
    record.echo = sensor % 3 != 0;
    record.range = 0.8 + 0.1 * sensor;
    const Shot shot = shot_of(record, belt, unit_from_angle(belt.bearing(sensor)));
    const double density = assimilate(found, shot, model_, scene).density;
    EXPECT_NEAR(assimilate(twin, shot, model_, scene).density / density, 1.0, 1e-6) << "sensor " << sensor;
  }
  EXPECT_LT(distance(twin.position, test::kFarCorner - found.position), 1e-6) << "and they are moved alike";
  EXPECT_NEAR(twin.speed, found.speed, 1e-6);
}

/// Seconds that a wearer whose start nobody told, among furniture that no plan knows, is surely taken to be where they
/// would be if their room were turned by half a turn.
double seconds_turned_about(const Building& building, std::uint64_t seed) {
  sim::RandomWalkOptions options;
  options.duration_s = 30.0;
  options.profile = *sim::profile_of("furnished");
  const auto walk = sim::simulate(building, sim::random_walk(building, options, seed));
  if (!walk) return 1e9;
  const scene::Scene scene(building, EchoModel({}, {}).sight_limits());
  BayesLocator locator(building, {}, {}, {.seed = seed});
  double seconds = 0.0;
  test::play(*walk, locator, [&](std::size_t i) {
    const TruthRow& truth = walk->truth[i];
    const Estimate& e = locator.estimate();
    const auto& room = scene.room(e.room);
    const double to_twin = distance(e.pose.position, room.low + room.high - truth.pose.position);
    const bool turned = to_twin < 0.5 && distance(e.pose.position, truth.pose.position) > 1.0;
    if (e.room == building.find_room(truth.room) && turned && e.state == TrackState::tracking) {
      seconds += BeltConfig{}.slot_s;
    }
  });
  return seconds;
}

// Each of these wearers walks past things that fit the other end of their room.
TEST(Twins, AreNotTakenForTheWearersPlaceForLong) {
  const auto lab = load_building(ECHOWAY_MAPS_DIR "/torgersen-lab");
  ASSERT_TRUE(lab);
  double seconds = 0.0;
  for (const std::uint64_t seed : {40079, 40096, 40136, 40191, 40227, 40234}) {
    seconds += seconds_turned_about(*lab, 101 * seed + 7);
  }
  EXPECT_LT(seconds, 55.0) << "twice as long when only what was found is believed, half as long with its twins";
}

}  // namespace
}  // namespace echoway::tracker
