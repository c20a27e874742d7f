#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "echoway/io/logs.hpp"
#include "support/process.hpp"

namespace echoway {
namespace {

using testing::HasSubstr;

class Logs : public testing::Test {
 protected:
  [[nodiscard]] Result<ScanLog> scans(std::string_view text) const { return read_scan_log(dir_.write("f.csv", text)); }
  [[nodiscard]] std::string scan_error(std::string_view text) const { return error_of(scans(text)); }
  [[nodiscard]] std::string motion_error(std::string_view text) const {
    return error_of(read_motion_log(dir_.write("f.csv", text)));
  }
  [[nodiscard]] std::string truth_error(std::string_view text) const {
    return error_of(read_truth_log(dir_.write("f.csv", text)));
  }
  [[nodiscard]] std::string track_error(std::string_view text) const {
    return error_of(read_track_log(dir_.write("f.csv", text)));
  }

  template <class T>
  static std::string error_of(const Result<T>& result) {
    return result.ok() ? "(read)" : result.error().to_string();
  }

  test::TemporaryFolder dir_;
};

// --- Scan logs
// ---------------------------------------------------------------------------------------------------------

TEST_F(Logs, ScansReadBeltCommentsAndBlankRanges) {
  const Result<ScanLog> log = scans(
      "# radius_m 0\n# beam_deg 55\n# a walk at "
      "noon\ntime_s,sensor,range_m\n0.0000,0,1.280\n0.0624,1,\n0.0624,2,0.8\n");
  ASSERT_TRUE(log.ok()) << log.error().to_string();
  EXPECT_EQ(log->belt.radius_m, 0.0);
  EXPECT_NEAR(*log->belt.beam_rad, degrees(55), 1e-12);
  EXPECT_FALSE(log->belt.sensors.has_value());
  ASSERT_EQ(log->firings.size(), 3U);
  EXPECT_DOUBLE_EQ(log->firings[0].range_m, 1.28);
  EXPECT_FALSE(log->firings[1].has_echo());
  EXPECT_EQ(log->firings[2].sensor, 2);
}

TEST_F(Logs, ScansMayComeFromAnySystem) {
  const Result<ScanLog> log =
      scans("\xEF\xBB\xBF# slot_s 0.05\r\n\r\n time_s , sensor , range_m \r\n0 , 1 , 2.5\r\n# a note\r\n1,2,");
  ASSERT_TRUE(log.ok()) << log.error().to_string();
  EXPECT_EQ(log->belt.slot_s, 0.05);
  EXPECT_EQ(log->firings.size(), 2U);
}

TEST_F(Logs, ScansMayBeEmptyButForTheHeader) {
  const Result<ScanLog> log = scans("time_s,sensor,range_m");
  ASSERT_TRUE(log.ok());
  EXPECT_TRUE(log->firings.empty());
}

TEST_F(Logs, ScansSayWhichRowIsWrong) {
  const std::string header = "time_s,sensor,range_m\n";
  EXPECT_THAT(scan_error(""), HasSubstr("f.csv:1: has no header line"));
  EXPECT_THAT(scan_error("0,0,1\n"), HasSubstr("f.csv:1: the header line must be 'time_s,sensor,range_m'"));
  EXPECT_THAT(scan_error("time_s,sensor\n"), HasSubstr("f.csv:1: the header line must be"));
  EXPECT_THAT(scan_error(header + "0,0\n"), HasSubstr("f.csv:2: has 2 fields where the header has 3"));
  EXPECT_THAT(scan_error(header + "0,0,1,2\n"), HasSubstr("f.csv:2: has 4 fields"));
  EXPECT_THAT(scan_error(header + ",0,1\n"), HasSubstr("f.csv:2: time_s is missing"));
  EXPECT_THAT(scan_error(header + "now,0,1\n"), HasSubstr("f.csv:2: time_s is 'now'"));
  EXPECT_THAT(scan_error(header + "1e300,0,1\n"), HasSubstr("beyond any sensible value"));
  EXPECT_THAT(scan_error(header + "0,0,1\n0.1,1,nan\n"), HasSubstr("f.csv:3: range_m is 'nan'"));
  EXPECT_THAT(scan_error(header + "0,0,inf\n"), HasSubstr("range_m is 'inf'"));
  EXPECT_THAT(scan_error(header + "0,0,-1\n"), HasSubstr("range_m is negative"));
  EXPECT_THAT(scan_error(header + "0,0,1e308\n"), HasSubstr("beyond any sensible value"));
  EXPECT_THAT(scan_error(header + "0,1.5,1\n"), HasSubstr("sensor is '1.5'"));
  EXPECT_THAT(scan_error(header + "0,-1,1\n"), HasSubstr("sensor is '-1', not a number from 0 to 14"));
  EXPECT_THAT(scan_error(header + "0,15,1\n"), HasSubstr("not a number from 0 to 14"));
  EXPECT_THAT(scan_error("# sensors 24\n" + header + "0,24,1\n"), HasSubstr("not a number from 0 to 23"));
  EXPECT_THAT(scan_error(header + "1,0,1\n0.9,1,1\n"), HasSubstr("f.csv:3: time_s goes back"));
}

TEST_F(Logs, ScansRefuseABeltThatMakesNoSense) {
  const std::string header = "\ntime_s,sensor,range_m\n";
  for (const char* comment :
       {"# sensors 0", "# sensors 65", "# sensors 1.5", "# sensors many", "# radius_m -0.1", "# radius_m nan",
        "# beam_deg 0", "# beam_deg 361", "# slot_s 0", "# temperature_c 500"}) {
    EXPECT_THAT(scan_error(comment + header), HasSubstr("f.csv:1: '")) << comment;
  }
  EXPECT_EQ(scan_error("# sensors were fifteen that day" + header), "(read)");
}

TEST_F(Logs, WhatIsNoTextIsRefused) {
  EXPECT_THAT(scan_error(std::string("time_s,sensor,range_m\n0,0,\0\n", 28)), HasSubstr("f.csv:2: holds control"));
  EXPECT_THAT(scan_error("time_s,sensor,range_m\n" + std::string(100'000, '1') + "\n"),
              HasSubstr("f.csv:2: line is longer"));
  EXPECT_THAT(error_of(read_scan_log(dir_.path())), HasSubstr("is a folder"));
  EXPECT_THAT(error_of(read_scan_log(dir_.path() / "none.csv")), HasSubstr("No such file"));
}

TEST_F(Logs, AScanLogCutAtAnyByteIsReadOrRefusedButNeverInvents) {
  ScanLog log;
  for (int i = 0; i < 4; ++i) log.firings.push_back({0.0624 * i, i, 1.0 + 0.1234 * i});
  const auto file = dir_.path() / "whole.csv";
  ASSERT_TRUE(write_scan_log(log, file).ok());
  const std::string text = test::read_file(file);
  for (std::size_t cut = 0; cut < text.size(); ++cut) {
    const Result<ScanLog> part = scans(std::string_view(text).substr(0, cut));
    if (!part.ok()) continue;
    ASSERT_LE(part->firings.size(), log.firings.size());
    for (std::size_t i = 0; i + 1 < part->firings.size(); ++i) {
      EXPECT_NEAR(part->firings[i].range_m, log.firings[i].range_m, 1e-9) << "only the last row can be cut";
    }
  }
}

TEST_F(Logs, ALastRowWithoutItsEndIsAnErrorWhereNoCutExplainsIt) {
  const std::string begun = "time_s,sensor,range_m\n0,0,1\n";
  for (const char* cut : {"0.1", "0.1,on", "0.1,1,-", "0.1,1,1e", "0.1,1,."}) {
    const Result<ScanLog> log = scans(begun + cut);
    ASSERT_TRUE(log.ok()) << cut << ": " << log.error().to_string();
    EXPECT_EQ(log->firings.size(), 1U) << cut;
  }
  for (const char* wrong :
       {"0.1,1,nan", "0.1,1,inf", "0.1,one,1.5", "0.1,99,1.5", "-1,1,1.5", "0.1,1,-1.5", "0.1,1,1,1"}) {
    EXPECT_THAT(scan_error(begun + wrong), HasSubstr("f.csv:3: ")) << wrong;
  }
  const std::string track = "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n0,a,1,2,3,0.1,1,";
  EXPECT_EQ(track_error(track + "track"), "(read)");
  EXPECT_THAT(track_error(track + "walking"), HasSubstr("state is 'walking'"));
}

TEST_F(Logs, ScansAreHeldToTheBeltThatTheCallerKnows) {
  const auto file = dir_.write("f.csv", "# sensors 15\ntime_s,sensor,range_m\n0,12,1\n");
  EXPECT_THAT(error_of(read_scan_log(file, 8)), HasSubstr("f.csv:3: sensor is '12', not a number from 0 to 7"));
  EXPECT_TRUE(read_scan_log(file, 24).ok());
}

TEST_F(Logs, ALogOfAMillionRowsIsReadAndAnEndlessOneRefused) {
  std::string text = "time_s,sensor,range_m\n";
  for (int i = 0; i < 1'000'000; ++i) text += "0,1,2\n";
  const Result<ScanLog> million = scans(text);
  ASSERT_TRUE(million.ok()) << million.error().to_string();
  EXPECT_EQ(million->firings.size(), 1'000'000U);
  for (int i = 0; i < 600'000; ++i) text += "0,1,2\n";
  EXPECT_THAT(scan_error(text), HasSubstr("f.csv:1500002: has more than 1500000 rows"));
}

TEST_F(Logs, ScansSayWhereTheWearerStartedAgain) {
  const Result<ScanLog> log = scans(
      "# restart the belt\n# restart -1 - - - -\ntime_s,sensor,range_m\n0,1,2\n# restart 0.5 hall 1.5 -2 450\n1,1,2\n"
      "# restarted\n");
  ASSERT_TRUE(log.ok()) << log.error().to_string();
  EXPECT_EQ(log->firings.size(), 2U);
  ASSERT_EQ(log->restarts.size(), 2U) << "anything else is prose";
  EXPECT_EQ(log->restarts[0].room, "");
  EXPECT_FALSE(log->restarts[0].position);
  EXPECT_EQ(log->restarts[1].time_s, 0.5);
  EXPECT_EQ(log->restarts[1].room, "hall");
  EXPECT_EQ(log->restarts[1].position, (Vec2{1.5, -2.0}));
  EXPECT_NEAR(*log->restarts[1].heading, degrees(90), 1e-9);
}

TEST_F(Logs, ScansSayWhichRestartMakesNoSense) {
  const auto error = [&](std::string_view restart) {
    return scan_error("time_s,sensor,range_m\n0,1,2\n# restart 3 a 1 1 0\n# restart " + std::string(restart) +
                      "\n1,1,2\n");
  };
  EXPECT_THAT(error("now hall 1 2 3"), HasSubstr("f.csv:4: 'now' is no sensible number"));
  EXPECT_THAT(error("4 hall 1e300 2 3"), HasSubstr("'1e300' is no sensible number"));
  EXPECT_THAT(error("4 hall 1 - 3"), HasSubstr("both x_m and y_m"));
  EXPECT_THAT(error("4 - 1 2 3"), HasSubstr("needs its room"));
  EXPECT_THAT(error("- hall 1 2 3"), HasSubstr("needs its time"));
  EXPECT_THAT(error("2 hall 1 2 3"), HasSubstr("goes back"));
}

TEST_F(Logs, WrittenRestartsAreReadBackThoughNothingFiresAfterThem) {
  ScanLog log;
  log.firings = {{0.0, 1, 2.0}, {1.0, 1, 2.0}};
  log.restarts = {{0.5, "hall", Vec2{1.25, 2.0}, degrees(30)}, {2.0, "", std::nullopt, std::nullopt}};
  const auto file = dir_.path() / "r.scans.csv";
  ASSERT_TRUE(write_scan_log(log, file).ok());
  const Result<ScanLog> back = read_scan_log(file);
  ASSERT_TRUE(back.ok()) << back.error().to_string();
  ASSERT_EQ(back->restarts.size(), 2U);
  EXPECT_EQ(back->restarts[0].room, "hall");
  EXPECT_EQ(back->restarts[0].position, log.restarts[0].position);
  EXPECT_NEAR(*back->restarts[0].heading, degrees(30), 1e-6);
  EXPECT_EQ(back->restarts[1].time_s, 2.0);
  EXPECT_TRUE(back->restarts[1].room.empty());
}

TEST_F(Logs, WrittenScansAreReadBack) {
  ScanLog log;
  log.belt = {.sensors = 12, .radius_m = 0.14, .beam_rad = degrees(20), .slot_s = 0.05, .temperature_c = -21.5};
  log.firings = {{-1.5, 0, 0.0}, {0.0624, 3, 2.3456}, {0.1248, 4, Firing::kNoEcho}, {1.7e9, 11, 10.67}};
  const auto file = dir_.path() / "b.scans.csv";
  ASSERT_TRUE(write_scan_log(log, file).ok());
  const Result<ScanLog> back = read_scan_log(file);
  ASSERT_TRUE(back.ok()) << back.error().to_string();
  EXPECT_EQ(back->belt.sensors, 12);
  EXPECT_EQ(back->belt.radius_m, 0.14);
  EXPECT_NEAR(*back->belt.beam_rad, degrees(20), 1e-12);
  EXPECT_EQ(back->belt.slot_s, 0.05);
  EXPECT_EQ(back->belt.temperature_c, -21.5);
  ASSERT_EQ(back->firings.size(), log.firings.size());
  for (std::size_t i = 0; i < log.firings.size(); ++i) {
    EXPECT_DOUBLE_EQ(back->firings[i].time_s, log.firings[i].time_s);
    EXPECT_EQ(back->firings[i].sensor, log.firings[i].sensor);
    EXPECT_DOUBLE_EQ(back->firings[i].range_m, log.firings[i].range_m);
  }
}

// --- Motion
// ------------------------------------------------------------------------------------------------------------

TEST_F(Logs, MotionIsReadInRadians) {
  const auto hints =
      read_motion_log(dir_.write("m.csv", "time_s,kind,value\n0,step,1\n0.1,yaw_rate_dps,-90\n0.1,heading_deg,450\n"));
  ASSERT_TRUE(hints.ok()) << hints.error().to_string();
  ASSERT_EQ(hints->size(), 3U);
  EXPECT_EQ((*hints)[0].kind, MotionKind::step);
  EXPECT_EQ((*hints)[0].value, 1.0);
  EXPECT_NEAR((*hints)[1].value, -kPi / 2, 1e-12);
  EXPECT_EQ((*hints)[2].kind, MotionKind::heading);
  EXPECT_NEAR((*hints)[2].value, 2.5 * kPi, 1e-12) << "turns add up";
}

TEST_F(Logs, MotionSaysWhichRowIsWrong) {
  const std::string header = "time_s,kind,value\n";
  EXPECT_THAT(motion_error(header + "0,jump,1\n"), HasSubstr("f.csv:2: kind is 'jump'"));
  EXPECT_THAT(motion_error(header + "0,step,\n"), HasSubstr("value is missing"));
  EXPECT_THAT(motion_error(header + "0,step,1.0\n1,step,2\n"), HasSubstr("f.csv:3: the value of a step is '2', not 1"));
  EXPECT_THAT(motion_error(header + "0,yaw_rate_dps,nan\n"), HasSubstr("value is 'nan'"));
  EXPECT_THAT(motion_error(header + "1,step,1\n0,step,1\n"), HasSubstr("f.csv:3: time_s goes back"));
}

TEST_F(Logs, WrittenMotionIsReadBack) {
  const std::vector<MotionHint> hints{{0.5, MotionKind::step, 1.0},
                                      {0.51, MotionKind::yaw_rate, degrees(12.5)},
                                      {0.6, MotionKind::heading, degrees(-400)}};
  const auto file = dir_.path() / "m.csv";
  ASSERT_TRUE(write_motion_log(hints, file).ok());
  const auto back = read_motion_log(file);
  ASSERT_TRUE(back.ok()) << back.error().to_string();
  ASSERT_EQ(back->size(), hints.size());
  for (std::size_t i = 0; i < hints.size(); ++i) {
    EXPECT_EQ((*back)[i].kind, hints[i].kind);
    EXPECT_NEAR((*back)[i].value, hints[i].value, 1e-6);
  }
}

// --- Truth and tracks
// --------------------------------------------------------------------------------------------------

TEST_F(Logs, TruthMayHaveFurtherColumns) {
  const auto rows =
      read_truth_log(dir_.write("t.csv", "time_s,room,x_m,y_m,heading_deg,mood\n0,P,0.84,0.3,370,good\n"));
  ASSERT_TRUE(rows.ok()) << rows.error().to_string();
  ASSERT_EQ(rows->size(), 1U);
  EXPECT_EQ((*rows)[0].room, "P");
  EXPECT_NEAR((*rows)[0].pose.heading, degrees(10), 1e-12);
}

TEST_F(Logs, TruthSaysWhichRowIsWrong) {
  const std::string header = "time_s,room,x_m,y_m,heading_deg\n";
  EXPECT_THAT(truth_error(header + "0,,1,1,0\n"), HasSubstr("f.csv:2: room is missing"));
  EXPECT_THAT(truth_error(header + "0,A,1,,0\n"), HasSubstr("y_m is missing"));
  EXPECT_THAT(truth_error(header + "0,A,1,1,north\n"), HasSubstr("heading_deg is 'north'"));
  EXPECT_THAT(truth_error(header + "0,\xFF,1,1,0\n"), HasSubstr("room is not valid UTF-8"));
}

TEST_F(Logs, TracksSayWhichRowIsWrong) {
  const std::string header = "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n";
  EXPECT_EQ(track_error(header + "0,,0,0,0,9,0,searching\n"), "(read)") << "no room while searching";
  EXPECT_THAT(track_error(header + "0,A,1,1,0,0.1,0.9,here\n"), HasSubstr("f.csv:2: state is 'here'"));
  EXPECT_THAT(track_error(header + "0,A,1,1,0,-0.1,0.9,lost\n"), HasSubstr("sigma_m is negative"));
  EXPECT_THAT(track_error(header + "0,A,1,1,0,0.1,1.5,lost\n"), HasSubstr("room_probability is 1.5"));
}

TEST_F(Logs, WrittenTracksAreReadBack) {
  const std::vector<TrackRow> rows{
      {{0.0624, "A", {{1.2345, -2.5}, degrees(-179.5)}}, 0.05, 0.999999, TrackState::tracking},
      {{0.1248, "hall 2", {{0.0, 0.0}, kPi}}, 3.0, 0.25, TrackState::lost}};
  const auto file = dir_.path() / "t.csv";
  ASSERT_TRUE(write_track_log(rows, file).ok());
  const auto back = read_track_log(file);
  ASSERT_TRUE(back.ok()) << back.error().to_string();
  ASSERT_EQ(back->size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ((*back)[i].where.room, rows[i].where.room);
    EXPECT_NEAR(distance((*back)[i].where.pose.position, rows[i].where.pose.position), 0.0, 1e-9);
    EXPECT_NEAR(wrap_angle((*back)[i].where.pose.heading - rows[i].where.pose.heading), 0.0, 1e-6);
    EXPECT_EQ((*back)[i].state, rows[i].state);
    EXPECT_NEAR((*back)[i].room_probability, rows[i].room_probability, 1e-9);
  }
}

TEST_F(Logs, NothingIsWrittenThatCouldNotBeReadBack) {
  const auto file = dir_.path() / "t.csv";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(write_truth_log({{0.0, "A", {{nan, 0.0}, 0.0}}}, file).ok());
  EXPECT_FALSE(write_truth_log({{0.0, "A,B", {}}}, file).ok());
  EXPECT_FALSE(write_motion_log({{nan, MotionKind::step, 1.0}}, file).ok());
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace echoway
