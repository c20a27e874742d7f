#include "tracker/sensor_health.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

constexpr int kSensors = 15;

TEST(SensorHealth, ACoveredBeltStopsBeingEvidence) {
  SensorHealth health(kSensors);
  double trust = 1.0;
  for (int i = 0; i < 30; ++i) trust = health.trust(i % kSensors, false);
  EXPECT_EQ(trust, 0.0);
  EXPECT_EQ(health.trust(0, true), 1.0) << "heard again";
}

TEST(SensorHealth, NamesASensorThatRepeatsOneRangeWhileTheWearerWalks) {
  SensorHealth health(kSensors);
  for (int pass = 0; pass < 30; ++pass) {
    for (int s = 0; s < kSensors; ++s) {
      const double range = s == 4 ? 1.27 : 1.0 + 0.1 * ((pass * 7 + s) % 23);
      (void)health.trust(s, true);
      health.judge(s, true, range, 2.0 * pass, 0.0);
    }
  }
  ASSERT_EQ(health.suspicions().size(), 1u);
  EXPECT_EQ(health.suspicions()[0].sensor, 4);
  EXPECT_EQ(health.suspicions()[0].kind, SensorSuspicion::Kind::stuck);
  EXPECT_EQ(health.trust(4, true), 0.0);
}

TEST(SensorHealth, AWearerWhoStandsStillMakesNoSensorSuspect) {
  SensorHealth health(kSensors);
  for (int pass = 0; pass < 200; ++pass) {
    for (int s = 0; s < kSensors; ++s) {
      (void)health.trust(s, s % 2 == 0);
      health.judge(s, s % 2 == 0, 1.0 + 0.2 * s, 0.0, 0.0);
    }
  }
  EXPECT_TRUE(health.suspicions().empty());
}

TEST(SensorHealth, NamesSteadyNearReadingsThatNothingExplains) {
  SensorHealth health(kSensors);
  for (int pass = 0; pass < 40; ++pass) {
    for (int s = 0; s < kSensors; ++s) {
      (void)health.trust(s, true);
      const double range = s == 8 ? 1.1 + 0.05 * (pass % 5) : 1.0 + 0.1 * ((pass * 7 + s) % 23);
      health.judge(s, true, range, 0.8 * pass, s == 8 ? 0.95 : 0.1);
    }
  }
  ASSERT_EQ(health.suspicions().size(), 1u);
  EXPECT_EQ(health.suspicions()[0].kind, SensorSuspicion::Kind::interference);
}

TEST(SensorHealth, DoesNotBlameTheSensorsWhenNothingFits) {
  SensorHealth health(kSensors);
  for (int pass = 0; pass < 100; ++pass) {
    for (int s = 0; s < kSensors; ++s) {
      (void)health.trust(s, true);
      health.judge(s, true, 0.6 + 0.05 * ((pass * 7 + s) % 23), 0.8 * pass, 0.95);
      EXPECT_LE(health.suspicions().size(), 3u);
    }
  }
}

}  // namespace
}  // namespace echoway::tracker
