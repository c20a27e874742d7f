#include "echoway/io/logs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temp_dir.hpp"

namespace echoway {
namespace {

using testing::HasSubstr;

TEST(ScanLog, ReadsBeltCommentsAndBlankRanges) {
  const test::TempDir dir;
  const auto file = dir.write("a.scans.csv",
                              "# radius_m 0\n# beam_deg 55\n# a walk at noon\ntime_s,sensor,range_m\n"
                              "0.0000,0,1.280\n0.0624,1,\n0.0624,2,0.8\n");
  const Result<ScanLog> log = read_scan_log(file);
  ASSERT_TRUE(log.ok()) << log.error().to_string();
  EXPECT_EQ(log->belt.radius_m, 0.0);
  EXPECT_NEAR(*log->belt.beam_rad, degrees(55), 1e-12);
  EXPECT_FALSE(log->belt.sensors.has_value());
  ASSERT_EQ(log->firings.size(), 3U);
  EXPECT_DOUBLE_EQ(log->firings[0].range_m, 1.28);
  EXPECT_FALSE(log->firings[1].has_echo());
  EXPECT_EQ(log->firings[2].sensor, 2);
}

TEST(ScanLog, WhatIsWrittenIsReadBack) {
  const test::TempDir dir;
  ScanLog log;
  log.belt = {.sensors = 12, .radius_m = 0.14, .beam_rad = degrees(20), .slot_s = 0.05, .temperature_c = 21.5};
  log.firings = {{0.0624, 3, 2.3456}, {0.1248, 4, Firing::kNoEcho}};
  const auto file = dir.path() / "b.scans.csv";
  ASSERT_TRUE(write_scan_log(log, file).ok());
  const Result<ScanLog> back = read_scan_log(file);
  ASSERT_TRUE(back.ok()) << back.error().to_string();
  EXPECT_EQ(back->belt.sensors, 12);
  EXPECT_EQ(back->belt.temperature_c, 21.5);
  EXPECT_DOUBLE_EQ(back->firings[0].range_m, 2.3456);
  EXPECT_DOUBLE_EQ(back->firings[1].time_s, 0.1248);
  EXPECT_FALSE(back->firings[1].has_echo());
}

TEST(ScanLog, SaysWhereARowIsWrong) {
  const test::TempDir dir;
  const auto file = dir.write("c.scans.csv", "time_s,sensor,range_m\n0,0,1\n0.1,1,nan\n");
  const Result<ScanLog> log = read_scan_log(file);
  ASSERT_FALSE(log.ok());
  EXPECT_THAT(log.error().to_string(), HasSubstr("c.scans.csv:3: range_m is 'nan'"));
}

}  // namespace
}  // namespace echoway
