#include "echoway/belt/belt_monitor.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace echoway {
namespace {

constexpr double kSlot = 0.0624;
constexpr int kSensors = 15;

// Fires round and round; `range(sensor)` says what each sensor reads.
template <class Range>
double fire_rounds(BeltMonitor& monitor, int rounds, double from, Range range) {
  double time = from;
  for (int i = 0; i < rounds * kSensors; ++i) {
    time = from + i * kSlot;
    monitor.on_firing({time, i % kSensors, range(i % kSensors)});
  }
  return time;
}

TEST(BeltMonitor, ReportsLinkRateAndShareOfEchoes) {
  BeltMonitor monitor(kSensors);
  EXPECT_EQ(monitor.health().link, BeltLink::absent);
  const double now = fire_rounds(monitor, 20, 0.0, [](int s) { return s % 3 == 0 ? 2.0 : Firing::kNoEcho; });
  monitor.on_tick(now);
  EXPECT_EQ(monitor.health().link, BeltLink::connected);
  EXPECT_NEAR(monitor.health().firings_per_second, 1.0 / kSlot, 0.1);
  EXPECT_EQ(monitor.health().sensors[3].echoes, 20);
  EXPECT_EQ(monitor.health().sensors[4].echoes, 0);
  EXPECT_EQ(monitor.health().sensors[4].firings, 20);
  EXPECT_EQ(monitor.health().sensors[4].state, SensorState::good) << "no echo is what most sensors hear";
}

TEST(BeltMonitor, ForgetsWhatIsOlderThanAMinute) {
  BeltMonitor monitor(kSensors);
  fire_rounds(monitor, 10, 0.0, [](int) { return 2.0; });
  const double now = fire_rounds(monitor, 5, 100.0, [](int) { return 2.0; });
  monitor.on_tick(now);
  EXPECT_EQ(monitor.health().sensors[0].firings, 5);
}

TEST(BeltMonitor, NoticesSilenceWithinTwoSecondsAndTheReturn) {
  BeltMonitor monitor(kSensors);
  const double now = fire_rounds(monitor, 2, 0.0, [](int) { return 2.0; });
  monitor.on_tick(now + 1.0);
  EXPECT_EQ(monitor.health().link, BeltLink::connected);
  monitor.on_tick(now + 1.9);
  EXPECT_EQ(monitor.health().link, BeltLink::lost);
  monitor.on_firing({now + 5.0, 0, 2.0});
  EXPECT_EQ(monitor.health().link, BeltLink::connected);
}

TEST(BeltMonitor, TellsACoveredSensorAndItsRecovery) {
  BeltMonitor monitor(kSensors);
  double now = fire_rounds(monitor, 5, 0.0, [](int s) { return s == 7 ? 0.16 : 2.0; });
  EXPECT_EQ(monitor.health().sensors[7].state, SensorState::good) << "an arm held there for a while is no cover";
  now = fire_rounds(monitor, 5, now + kSlot, [](int s) { return s == 7 ? 0.16 : 2.0; });
  EXPECT_EQ(monitor.health().sensors[7].state, SensorState::stuck);
  EXPECT_EQ(monitor.health().sensors[6].state, SensorState::good);
  fire_rounds(monitor, 1, now + kSlot, [](int) { return 2.0; });
  EXPECT_EQ(monitor.health().sensors[7].state, SensorState::good);
}

TEST(BeltMonitor, TellsASensorThatTheBeltSkips) {
  BeltMonitor monitor(kSensors);
  double now = 0.0;
  for (int i = 0; i < 5 * kSensors; ++i) {
    now = i * kSlot;
    if (i % kSensors != 4) monitor.on_firing({now, i % kSensors, 2.0});
  }
  monitor.on_tick(now);
  EXPECT_EQ(monitor.health().sensors[4].state, SensorState::silent);
  EXPECT_EQ(monitor.health().sensors[5].state, SensorState::good);
}

TEST(BeltMonitor, KeepsAFaultUntilTheSensorAnswersAgain) {
  BeltMonitor monitor(kSensors);
  monitor.on_fault(2, 9, 0.5);
  EXPECT_EQ(monitor.health().sensors[2].state, SensorState::fault);
  EXPECT_EQ(monitor.health().sensors[2].fault_code, 9);
  monitor.on_firing({1.0, 2, Firing::kNoEcho});
  EXPECT_EQ(monitor.health().sensors[2].state, SensorState::fault);
  monitor.on_firing({2.0, 2, 3.0});
  EXPECT_EQ(monitor.health().sensors[2].state, SensorState::good);
}

TEST(BeltMonitor, KeepsWhatTheStatusSentenceSays) {
  BeltMonitor monitor(kSensors);
  monitor.on_status(12, "2.1", 21.5, 3.71, 1.0);
  monitor.on_status(std::nullopt, "", std::nullopt, std::nullopt, 2.0);
  EXPECT_EQ(monitor.health().sensor_count, 12);
  EXPECT_STREQ(monitor.health().firmware.data(), "2.1");
  EXPECT_DOUBLE_EQ(monitor.health().temperature_c, 21.5);
  EXPECT_DOUBLE_EQ(monitor.health().battery_v, 3.71);
}

TEST(BeltMonitor, SurvivesImpossibleInput) {
  BeltMonitor monitor(kSensors);
  monitor.on_firing({std::numeric_limits<double>::quiet_NaN(), 0, 1.0});
  monitor.on_firing({0.0, -1, 1.0});
  monitor.on_firing({0.0, 64, 1.0});
  monitor.on_firing({1e300, 0, 1.0});
  monitor.on_fault(-3, 1, 0.0);
  monitor.on_status(1000, std::string(200, 'x'), std::nullopt, std::nullopt, 0.0);
  monitor.on_tick(std::numeric_limits<double>::infinity());
  EXPECT_EQ(monitor.health().sensor_count, kSensors);
  EXPECT_EQ(std::string(monitor.health().firmware.data()).size(), monitor.health().firmware.size() - 1);
}

}  // namespace
}  // namespace echoway
