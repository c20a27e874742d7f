// One effect at a time, in a world without noise and without anything that is not in the plan.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/rooms.hpp"

namespace echoway::sim {
namespace {

constexpr double kSilence = Firing::kNoEcho;
constexpr double kRise = 0.06;  // A weak echo crosses the threshold later in its rise: at most this far, metres.

// Large enough that only what a test puts near is heard.
Building hall() { return one_room(rooms::rectangle(20.0, 20.0)); }

Building hall_with(Segment screen) {
  Building building = hall();
  building.rooms[0].walls.push_back(screen);
  return building;
}

TEST(SimAcoustics, AWallAnswersFromTheTransducersFace) {
  Ring ring;
  ring.belt.radius_m = 0.15;
  ring.bearings_rad = {0.0};
  const auto log = scan_at(hall(), ideal_world(), ring, {{0.0, "P", {{18.0, 10.0}, 0.0}}}, 1);
  ASSERT_TRUE(log.ok());
  EXPECT_NEAR(log->firings[0].range_m, 2.0 - 0.15, 0.005);
}

TEST(SimAcoustics, AWallMetAskewIsSilent) {
  EXPECT_NEAR(look(hall(), ideal_world(), {18.0, 10.0}, 0.0), 2.0, 0.005);
  for (const double askew : {20.0, 30.0, 45.0, 60.0}) {
    EXPECT_EQ(look(hall(), ideal_world(), {18.0, 10.0}, askew), kSilence) << askew;
  }
}

TEST(SimAcoustics, ASideLobeHearsALoudWall) {
  World loud = ideal_world();
  loud.plane_margin_db = 50.0;
  EXPECT_NEAR(look(hall(), loud, {18.0, 10.0}, 20.0), 2.0, kRise);
}

TEST(SimAcoustics, ARightAngledCornerAnswersWhereItsWallsAreSilent) {
  const Vec2 from{18.0, 18.0};
  EXPECT_NEAR(look(hall(), ideal_world(), from, 45.0), std::hypot(2.0, 2.0), 0.01);
  EXPECT_NEAR(look(hall(), ideal_world(), from, 50.0), std::hypot(2.0, 2.0), kRise);
}

TEST(SimAcoustics, ACornerThatIsNotRightIsSilent) {
  const Building building = one_room(rooms::polygon({{0.0, 0.0}, {8.0, 0.0}, {4.0, 7.0}}));
  const double to_corner = to_degrees(std::atan2(7.0 - 3.0, 0.0));
  EXPECT_EQ(look(building, ideal_world(), {4.0, 3.0}, to_corner), kSilence);
}

TEST(SimAcoustics, AnEdgeAnswersNearbyAndIsTooWeakFarOff) {
  // The end of a screen that runs straight away from the sensor.
  const Building building = hall_with({{10.0, 10.0}, {13.0, 10.0}});
  World world = ideal_world();
  world.edge_gain_db = 14.0;
  EXPECT_NEAR(look(building, world, {9.0, 10.0}, 0.0), 1.0, kRise);
  EXPECT_EQ(look(building, world, {5.0, 10.0}, 0.0), kSilence);
}

TEST(SimAcoustics, ARoughWallAnswersAtAnyIncidence) {
  // Thesis section 6.2.5: near a wall sensors hear it at 30 to 60 degrees.
  World rough = ideal_world();
  rough.rough_walls = 1.0;
  int heard = 0;
  for (int askew = 30; askew <= 60; askew += 2) {
    EXPECT_EQ(look(hall(), ideal_world(), {19.0, 10.0}, askew), kSilence) << askew;
    heard += look(hall(), rough, {19.0, 10.0}, askew) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(heard, 8);
}

TEST(SimAcoustics, ThinPostsAnswerWhereWallsAreSilent) {
  const Building room = one_room(rooms::rectangle(8.0, 8.0));
  World posts = ideal_world();
  posts.posts_per_m2 = 0.5;
  int bare = 0;
  int with_posts = 0;
  for (int angle = 0; angle < 360; angle += 5) {
    bare += look(room, ideal_world(), {4.0, 4.0}, angle) != kSilence ? 1 : 0;
    with_posts += look(room, posts, {4.0, 4.0}, angle) != kSilence ? 1 : 0;
  }
  EXPECT_GT(with_posts, bare + 5);
}

TEST(SimAcoustics, ABenchAnswersAtAnyIncidence) {
  Building building = hall();
  building.rooms[0].reflectors = {{{12.0, 6.0}, {12.0, 14.0}}};
  int heard = 0;
  for (int i = 0; i < 20; ++i) {
    const double askew = 25.0 + i;
    const double range = look(building, ideal_world(), {10.0, 8.0}, askew);
    heard += range > 0.0 && std::abs(range * std::cos(degrees(askew)) - 2.0) < 0.5;
  }
  EXPECT_GE(heard, 15);
}

TEST(SimAcoustics, SoundComesBackByWayOfAWallMetAskew) {
  // A chamfer at 45 degrees turns the beam by a right angle onto the far wall and back again: wall, wall, wall.
  const Building building = one_room(rooms::polygon({{0.0, 0.0}, {8.0, 0.0}, {8.0, 2.0}, {6.0, 4.0}, {0.0, 4.0}}));
  World world = ideal_world();
  const Vec2 from{3.0, 3.0};  // Meets the chamfer at (7, 3), goes down 3 m.
  EXPECT_EQ(look(building, world, from, 0.0), kSilence);
  world.mirror_paths = true;
  EXPECT_NEAR(look(building, world, from, 0.0), 4.0 + 3.0, kRise);
}

TEST(SimAcoustics, AWideBeamUsesMirrorsFarOffItsAxis) {
  // The same chamfer, 35 degrees off the axis: within the beam of a small disc at 40 kHz.
  const Building building = one_room(
      rooms::polygon({{0.0, 0.0}, {7.6, 0.0}, {8.0, 0.4}, {8.0, 2.0}, {6.0, 4.0}, {0.0, 4.0}}));
  World world = ideal_world();
  world.frequency_hz = 40e3;
  world.transducer_radius_m = 6.5e-3;
  EXPECT_GT(std::abs(look(building, world, {3.0, 3.0}, -35.0) - 7.0), kRise);
  world.mirror_paths = true;
  EXPECT_NEAR(look(building, world, {3.0, 3.0}, -35.0), 4.0 + 3.0, kRise);
}

TEST(SimAcoustics, SoundGoesRoundATriangleOfTwoWalls) {
  // Two walls that meet at 80 degrees send sound back 20 degrees from where it left; unfolding gives the path's length.
  const double half = degrees(40.0);
  const Vec2 apex{10.0, 10.0};
  Building building = hall();
  building.rooms[0].walls.push_back({apex, apex + 4.0 * unit_from_angle(kPi - half)});
  building.rooms[0].walls.push_back({apex, apex + 4.0 * unit_from_angle(kPi + half)});
  World world = ideal_world();
  world.mirror_paths = true;
  const double away = 1.0;
  // The wedge rotates the image of the sensor by twice its opening about the apex.
  const double unfolded = away * std::sin(2.0 * half);
  EXPECT_NEAR(look(building, world, apex - Vec2{away, 0.0}, 0.0), unfolded, kRise);
}

TEST(SimAcoustics, TheWearersBodyBlocksSoundThatComesRoundIt) {
  // A screen close before the wearer turns the beam round by 160 degrees, past the wearer's side, to a screen behind.
  const Vec2 wearer{10.0, 10.0};
  const Vec2 turn = wearer + Vec2{0.32, 0.0};
  const Vec2 back = unit_from_angle(degrees(200.0));
  const Vec2 mirror = perpendicular(unit_from_angle(degrees(190.0)));
  Building building = hall_with({turn - 0.3 * mirror, turn + 0.3 * mirror});
  const Vec2 far = turn + 3.0 * back;
  building.rooms[0].walls.push_back({far - 0.5 * perpendicular(back), far + 0.5 * perpendicular(back)});
  World world = ideal_world();
  world.transducer_radius_m = 0.04;  // A beam that is too narrow for the near screen to answer.
  world.mirror_paths = true;
  Ring ring;
  ring.bearings_rad = {0.0};
  ring.belt.radius_m = 0.0;
  const auto without = scan_at(building, world, ring, {{0.0, "P", {wearer, 0.0}}}, 1);
  ring.belt.radius_m = 0.15;
  const auto with = scan_at(building, world, ring, {{0.0, "P", {wearer, 0.0}}}, 1);
  ASSERT_TRUE(without.ok() && with.ok());
  EXPECT_NEAR(without->firings[0].range_m, 3.32, kRise);
  EXPECT_EQ(with->firings[0].range_m, kSilence);
}

TEST(SimAcoustics, AScreenHidesWhatIsBehind) {
  EXPECT_NEAR(look(hall(), ideal_world(), {16.0, 10.0}, 0.0), 4.0, 0.01);
  // Askew, so that it does not answer itself.
  EXPECT_EQ(look(hall_with({{17.0, 8.0}, {19.0, 12.0}}), ideal_world(), {16.0, 10.0}, 0.0), kSilence);
}

TEST(SimAcoustics, AnOpenDoorLetsSoundIntoTheNextRoomAndAShutOneDoesNot) {
  const Building building = three_rooms();
  World world = ideal_world();
  EXPECT_NEAR(look(building, world, {4.0, 2.0}, 0.0), 1.0 + 6.0, kRise);
  world.doors_shut = 1.0;
  EXPECT_NEAR(look(building, world, {4.0, 2.0}, 0.0), 1.0, 0.05);
}

TEST(SimAcoustics, AWallDrawnThroughADoorDoesNotAnswerInTheOpening) {
  const Building building = three_rooms();
  EXPECT_NEAR(look(building, ideal_world(), {4.0, 1.0}, 0.0), 1.0, 0.01);
  EXPECT_GT(look(building, ideal_world(), {4.0, 2.0}, 0.0), 2.0);
}

TEST(SimAcoustics, RoomsThatOverlapOnThePlanDoNotLeakIntoOneAnother) {
  Building building = three_rooms();
  building.rooms.push_back(box_room("ghost", {1.0, 1.0}, 2.0, 2.0));  // Inside the hall, joined to nothing.
  EXPECT_NEAR(look(building, ideal_world(), {2.0, 2.0}, 180.0), 2.0, 0.01);
}

TEST(SimAcoustics, AWeakEchoReadsTooFarByLessThanItsRise) {
  const double strong = look(hall(), ideal_world(), {18.0, 10.0}, 0.0);
  const double weak = look(hall(), ideal_world(), {18.0, 10.0}, 11.0);
  ASSERT_GT(weak, 0.0);
  EXPECT_GT(weak, strong + 0.005);
  EXPECT_LT(weak, strong + kRise);
}

TEST(SimAcoustics, GainStopsRisingAndFarWallsFallSilent) {
  World world = ideal_world();
  const Building building = one_room(rooms::rectangle(60.0, 60.0));
  world.plane_margin_db = 12.0;
  EXPECT_NEAR(look(building, world, {54.0, 30.0}, 0.0), 6.0, kRise);
  EXPECT_EQ(look(building, world, {49.5, 30.0}, 0.0), kSilence);
}

TEST(SimAcoustics, WarmAirShortensRanges) {
  World warm = ideal_world();
  warm.temperature_c = 32.0;
  const double expected = 4.0 * speed_of_sound(kReferenceCelsius) / speed_of_sound(32.0);
  EXPECT_NEAR(look(hall(), warm, {16.0, 10.0}, 0.0), expected, 0.01);
}

TEST(SimAcoustics, TheAirIsWarmerTowardsOneSideOfALevel) {
  // Readings of a wall 4 m off from places 12 m apart, across the hall and along it, tell the gradient's two parts.
  World world = ideal_world();
  world.temperature_gradient_k_per_m = 1.0;
  const auto kelvins = [](double near, double far) {
    const double kelvin = speed_of_sound(21.0) / speed_of_sound(20.0) - 1.0;
    return std::log(near / far) / kelvin;
  };
  const double across = kelvins(look(hall(), world, {16.0, 4.0}, 0.0), look(hall(), world, {16.0, 16.0}, 0.0));
  const double along = kelvins(look(hall(), world, {4.0, 16.0}, 90.0), look(hall(), world, {16.0, 16.0}, 90.0));
  EXPECT_NEAR(std::hypot(across, along), 12.0, 1.0);
}

TEST(SimAcoustics, RangesAreWholeTicksOfTheTimer) {
  World coarse = ideal_world();
  coarse.timer_tick_s = 100e-6;
  const double tick = 0.5 * 100e-6 * speed_of_sound(kReferenceCelsius);
  for (const double x : {15.0, 15.37, 16.213}) {
    const double ticks = look(hall(), coarse, {x, 10.0}, 0.0) / tick;
    EXPECT_NEAR(ticks, std::round(ticks), 1e-9);
  }
}

TEST(SimAcoustics, RandomWorldsHearAWallWithin7To13DegreesOfItsNormal) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const World drawn = random_world(Profile::empty, random);
    World world = ideal_world();
    world.transducer_radius_m = drawn.transducer_radius_m;
    world.plane_margin_db = drawn.plane_margin_db;
    world.temperature_c = drawn.temperature_c;
    EXPECT_GT(look(hall(), world, {18.0, 10.0}, 6.9), 0.0);
    EXPECT_EQ(look(hall(), world, {18.0, 10.0}, 13.2), kSilence);
  }
}

TEST(SimAcoustics, NothingNearerThanTheLeastRangeIsHeard) {
  EXPECT_EQ(look(hall(), ideal_world(), {19.9, 10.0}, 0.0), kSilence);
}

}  // namespace
}  // namespace echoway::sim
