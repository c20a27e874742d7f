#include "thesis/scan.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "echoway/random.hpp"

namespace echoway::thesis {
namespace {

BeltConfig belt_with(int sensors) {
  BeltConfig belt;
  belt.sensors = sensors;
  return belt;
}

// Feeds whole passes, `range(pass, sensor)` each; returns how many scans were completed.
template <class Range>
int feed_passes(ScanAssembler& assembler, int sensors, int passes, Range range) {
  int scans = 0;
  for (int i = 0; i < passes * sensors; ++i) {
    scans += assembler.add({i * 0.0624, i % sensors, range(i / sensors, i % sensors)}) ? 1 : 0;
  }
  return scans;
}

TEST(ScanAssembler, AveragesTwoPasses) {
  ScanAssembler assembler(belt_with(3), {});
  // Sensor s reads 1 + s in the first pass and 1.2 + s in the second.
  EXPECT_EQ(feed_passes(assembler, 3, 2, [](int pass, int s) { return 1.0 + s + 0.2 * pass; }), 1);
  ASSERT_EQ(assembler.scan().readings().size(), 3U);
  for (const Reading& r : assembler.scan().readings()) EXPECT_DOUBLE_EQ(r.range_m, 1.1 + r.sensor);
  // Firings at 0, 62.4, ... 312 ms: the mean is 156 ms.
  EXPECT_NEAR(assembler.scan().time_s, 0.156, 1e-12);
}

TEST(ScanAssembler, LeavesMissingEchoesOutOfTheAverage) {
  // Twice the maximum range, averaged with 2 m, would be 11.67 m.
  ScanAssembler assembler(belt_with(2), {});
  feed_passes(assembler, 2, 2, [](int pass, int s) { return pass == 0 && s == 0 ? 2.0 : Firing::kNoEcho; });
  ASSERT_EQ(assembler.scan().readings().size(), 1U);
  EXPECT_DOUBLE_EQ(assembler.scan().readings()[0].range_m, 2.0);
  ASSERT_EQ(assembler.scan().silent().size(), 1U);
  EXPECT_EQ(assembler.scan().silent()[0], 1);
}

TEST(ScanAssembler, IsNotHeldUpByLostFirings) {
  // Sensor 4 never fires; every seventh firing of the rest is lost.
  ScanAssembler assembler(belt_with(15), {});
  int scans = 0;
  for (int i = 0; i < 600; ++i) {
    const int sensor = i % 15;
    if (sensor == 4 || i % 7 == 0) continue;
    scans += assembler.add({i * 0.0624, sensor, 2.0}) ? 1 : 0;
  }
  EXPECT_GE(scans, 15);
  EXPECT_LE(scans, 20);
}

TEST(ScanAssembler, NeedsNoOrder) {
  Random random(5);
  ScanAssembler assembler(belt_with(15), {});
  int scans = 0;
  for (int i = 0; i < 3000; ++i) {
    scans += assembler.add({i * 0.0624, static_cast<int>(random.uniform(0.0, 15.0)), 2.0}) ? 1 : 0;
  }
  EXPECT_GE(scans, 100);
}

TEST(ScanAssembler, WorksWithOneSensorAndWithSixtyFour) {
  for (const int sensors : {1, 2, 64}) {
    ScanAssembler assembler(belt_with(sensors), {});
    EXPECT_EQ(feed_passes(assembler, sensors, 6, [](int, int) { return 1.0; }), 3) << sensors;
    EXPECT_EQ(assembler.scan().readings().size(), static_cast<std::size_t>(sensors));
  }
}

TEST(ScanAssembler, ForgetsAnUnfinishedScanAfterALongPause) {
  // One firing, then a day later two passes: the first does not spoil the average.
  ScanAssembler assembler(belt_with(2), {});
  assembler.add({0.0, 0, 9.0});
  for (int i = 0; i < 4; ++i) assembler.add({86400.0 + 0.06 * i, i % 2, 3.0});
  ASSERT_EQ(assembler.scan().readings().size(), 2U);
  EXPECT_DOUBLE_EQ(assembler.scan().readings()[0].range_m, 3.0);
  EXPECT_GT(assembler.scan().time_s, 86400.0 - 1.0);
}

TEST(DropOutliers, DropsWhatIsBeyondTheMeanPlusTwoDeviations) {
  // Nine readings of 2 and one of 9: mean 2.7, deviation 2.1, limit 6.9.
  std::vector<Reading> readings;
  for (int s = 0; s < 10; ++s) readings.push_back({s, s == 3 ? 9.0 : 2.0});
  ASSERT_EQ(drop_outliers(readings, 2.0), 9);
  for (int i = 0; i < 9; ++i) EXPECT_DOUBLE_EQ(readings[static_cast<std::size_t>(i)].range_m, 2.0);
  EXPECT_EQ(readings[3].sensor, 4);
}

TEST(DropOutliers, KeepsShortReadingsAndEqualOnes) {
  std::vector<Reading> short_one = {{0, 5.0}, {1, 5.0}, {2, 5.0}, {3, 5.0}, {4, 5.0}, {5, 5.0}, {6, 0.2}};
  EXPECT_EQ(drop_outliers(short_one, 2.0), 7);
  std::vector<Reading> equal(15, Reading{0, 1.1});
  EXPECT_EQ(drop_outliers(equal, 2.0), 15);
  EXPECT_EQ(drop_outliers({}, 2.0), 0);
}

}  // namespace
}  // namespace echoway::thesis
