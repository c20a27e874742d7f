#include <gtest/gtest.h>

#include <string>

#include "support/process.hpp"

namespace echoway {
namespace {

using test::run_echoway;
using test::TemporaryFolder;

const std::string kLab = std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab";

TEST(Score, MeasuresATrackAgainstTheTruth) {
  // One second at walking pace along x in room 4; the track is 0.3 m off to the side, turned by 10 degrees, and in its
  // last row in the wrong room.
  const TemporaryFolder folder;
  const auto truth = folder.write("truth.csv", "time_s,room,x_m,y_m,heading_deg\n0,4,1.0,1.0,0\n1,4,1.5,1.0,0\n");
  const auto track = folder.write("track.csv",
                                  "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n"
                                  "0.0,4,1.00,1.3,10,0.2,1,tracking\n"
                                  "0.5,4,1.25,1.3,10,0.2,1,tracking\n"
                                  "0.8,4,1.40,1.3,350,0.1,1,tracking\n"
                                  "1.0,1,1.50,1.3,0,0.1,0.5,searching\n"
                                  "9.0,4,1.50,1.3,0,0.1,0.5,lost\n");
  const auto result = run_echoway({"score", "--building", kLab, "--track", track.string(), "--truth", truth.string()});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("rows             4\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("median 0.300 m (0.98 ft)"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("heading error    mean 7.5 deg"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("right room       75.0 %"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("within 2 sigma   50.0 %"), std::string::npos) << result.out;
}

TEST(Score, RowsThatNameNoRoomYetAreLeftOutAndCounted) {
  const TemporaryFolder folder;
  const std::string header =
      "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n0.2,,0,0,0,9,0,searching\n";
  const auto truth =
      folder.write("truth.csv", "time_s,room,x_m,y_m,heading_deg\n0,4,1.0,1.0,0\n1,4,1.0,1.0,0\n").string();
  const auto score = [&](const std::string& track) {
    return run_echoway(
        {"score", "--building", kLab, "--track", folder.write("track.csv", track).string(), "--truth", truth});
  };
  const auto result = score(header + "0.5,4,1.1,1.0,0,0.2,1,tracking\n");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("rows             1\nwithout a room   1, left out\n"), std::string::npos) << result.out;
  EXPECT_EQ(score(header).status, 2);
}

TEST(Score, RefusesLogsThatHaveNothingInCommon) {
  const TemporaryFolder folder;
  const auto truth = folder.write("truth.csv", "time_s,room,x_m,y_m,heading_deg\n0,4,1.0,1.0,0\n");
  const auto track = folder.write(
      "track.csv", "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n5,4,1,1,0,0.2,1,tracking\n");
  const auto result = run_echoway({"score", "--building", kLab, "--track", track.string(), "--truth", truth.string()});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("share no time"), std::string::npos) << result.err;
}

TEST(Score, SaysOfATrackThatItIsEmpty) {
  const TemporaryFolder folder;
  const auto truth = folder.write("truth.csv", "time_s,room,x_m,y_m,heading_deg\n0,4,1.0,1.0,0\n");
  const auto track = folder.write("track.csv", "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n");
  const auto result = run_echoway({"score", "--building", kLab, "--track", track.string(), "--truth", truth.string()});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, track.string() + ": the track has no rows\n");
}

TEST(Score, SaysInWhichLineIsARoomThatTheBuildingDoesNotHave) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& track_room, const std::string& truth_room) {
    const auto truth =
        folder.write("truth.csv", "time_s,room,x_m,y_m,heading_deg\n0,4,1,1,0\n9," + truth_room + ",1,1,0\n");
    const auto track =
        folder.write("track.csv", "# mine\ntime_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n5," +
                                      track_room + ",1,1,0,0.2,1,tracking\n");
    const auto result =
        run_echoway({"score", "--building", kLab, "--track", track.string(), "--truth", truth.string()});
    EXPECT_EQ(result.status, 2);
    return result.err;
  };
  EXPECT_NE(error("4", "cellar").find("truth.csv:3: the truth names room 'cellar'"), std::string::npos)
      << error("4", "cellar");
  EXPECT_NE(error("attic", "4").find("track.csv:3: the track names room 'attic'"), std::string::npos)
      << error("attic", "4");
}

}  // namespace
}  // namespace echoway
