#include "tracker/echo_repeats.hpp"

#include <gtest/gtest.h>

#include "echoway/units.hpp"

namespace echoway::tracker {
namespace {

double density_at(EchoRepeats& repeats, const BeltConfig& belt, int sensor, double range, double time_s) {
  double sum = 0.0;
  for (const Repeat& r : repeats.match(belt, sensor, range, time_s)) sum += r.density;
  return sum;
}

TEST(EchoRepeats, ExpectACupboardAheadNearerByTheWayWalked) {
  const BeltConfig belt;
  EchoRepeats repeats;
  repeats.note(belt, 0, 3.0, 0.0);
  repeats.move(0.5, 0.0);
  EXPECT_GT(density_at(repeats, belt, 0, 2.5, 0.94), 5.0 * density_at(repeats, belt, 0, 2.0, 0.94));
}

TEST(EchoRepeats, ExpectAnArmWhereItSwings) {
  const BeltConfig belt;
  EchoRepeats repeats;
  repeats.note(belt, 4, 0.25, 0.0);
  repeats.move(0.5, 0.0);
  EXPECT_GT(density_at(repeats, belt, 4, 0.25, 0.94), 0.5);
  EXPECT_EQ(density_at(repeats, belt, 9, 0.25, 0.94), 0.0) << "another sensor looks elsewhere";
}

TEST(EchoRepeats, FollowATurnToTheNextSensor) {
  const BeltConfig belt;
  EchoRepeats repeats;
  repeats.note(belt, 1, 2.0, 0.0);
  repeats.move(0.0, belt.bearing(1));   // What was to the left is now ahead.
  EXPECT_GT(density_at(repeats, belt, 0, 2.0, 0.9), 0.5);
}

TEST(EchoRepeats, ForgetWhatWasHeardLongAgo) {
  const BeltConfig belt;
  EchoRepeats repeats;
  repeats.note(belt, 0, 3.0, 0.0);
  EXPECT_GT(density_at(repeats, belt, 0, 3.0, 1.0), 0.5);
  EXPECT_EQ(density_at(repeats, belt, 0, 3.0, 10.0), 0.0);
}

}  // namespace
}  // namespace echoway::tracker
