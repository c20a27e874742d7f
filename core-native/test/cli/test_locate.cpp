#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "cli/start_option.hpp"
#include "echoway/io/logs.hpp"
#include "support/process.hpp"

namespace echoway {
namespace {

using test::ProcessResult;
using test::run_echoway;
using test::TemporaryFolder;

const std::string kLab = std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab";

/// A short simulated walk in the lab and where it starts.
class Locate : public testing::Test {
 protected:
  void SetUp() override {
    const ProcessResult simulated = run_echoway(
        {"simulate", "--building", kLab, "--random", "12", "--profile", "furnished", "--seed", "3", "--out", prefix_});
    ASSERT_EQ(simulated.status, 0) << simulated.err;
    const auto truth = read_truth_log(prefix_ + ".truth.csv");
    ASSERT_TRUE(truth.ok());
    start_ = test::start_option(truth->front());
  }

  ProcessResult locate(std::vector<std::string> more) {
    std::vector<std::string> arguments{"locate",  "--building", kLab, "--scans", prefix_ + ".scans.csv",
                                       "--track", track_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_echoway(arguments);
  }

  TemporaryFolder folder_;
  std::string prefix_ = (folder_.path() / "walk").string();
  std::string track_ = (folder_.path() / "track.csv").string();
  std::string start_;
};

TEST_F(Locate, WritesARowPerFiringWithTheTracker) {
  const ProcessResult result = locate({"--start", start_, "--motion", prefix_ + ".motion.csv"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_track_log(track_)->size(), read_scan_log(prefix_ + ".scans.csv")->firings.size());
}

// By the clock face a turn and a sharper one are told in the same words.
TEST(Cues, NobodyHearsTheSameWordsTwiceInTenSeconds) {
  const TemporaryFolder folder;
  const std::string prefix = (folder.path() / "walk").string();
  const std::string room = std::string(ECHOWAY_MAPS_DIR) + "/sample-room";
  std::size_t by_the_clock = 0;
  for (const char* seed : {"2", "5", "6", "7"}) {
    ASSERT_EQ(run_echoway({"simulate", "--building", room, "--random", "90", "--seed", seed, "--out", prefix}).status,
              0);
    ASSERT_EQ(run_echoway({"locate", "--building", room, "--scans", prefix + ".scans.csv", "--motion",
                           prefix + ".motion.csv", "--to", "exit", "--directions", "clock", "--track",
                           prefix + ".track.csv", "--cues", prefix + ".cues.csv"})
                  .status,
              0);
    std::istringstream rows(test::read_file(prefix + ".cues.csv"));
    std::string row;
    std::getline(rows, row);
    std::map<std::string, double> said;
    while (std::getline(rows, row)) {
      const double time = std::stod(row);
      const std::string words = row.substr(row.find('"'));
      const auto [before, fresh] = said.try_emplace(words, time);
      EXPECT_TRUE(fresh || time - before->second > 9.99) << "seed " << seed << ": " << words << " at " << time << " s";
      before->second = time;
      by_the_clock += words.find("o'clock") != std::string::npos;
    }
  }
  EXPECT_GT(by_the_clock, 10U);
}

TEST_F(Locate, WritesARowPerTwoPassesWithTheThesisMethod) {
  const ProcessResult result = locate({"--start", start_, "--method", "thesis"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_track_log(track_)->size(), read_scan_log(prefix_ + ".scans.csv")->firings.size() / 30);
}

TEST_F(Locate, StartsAgainWhereTheWearerSaid) {
  const auto truth = read_truth_log(prefix_ + ".truth.csv");
  auto log = read_scan_log(prefix_ + ".scans.csv");
  const TruthRow& then = (*truth)[truth->size() / 2];
  log->restarts.push_back({then.time_s, then.room, then.pose.position, then.pose.heading});
  ASSERT_TRUE(write_scan_log(*log, prefix_ + ".scans.csv").ok());
  // Told a wrong start, and the right place halfway.
  const std::string wrong = then.room == "hall" ? "1" : "hall";
  ASSERT_EQ(locate({"--start", wrong}).status, 0);
  const auto track = read_track_log(track_);
  const auto at = std::find_if(track->begin(), track->end(),
                               [&](const TrackRow& r) { return r.where.time_s >= then.time_s + 0.5; });
  ASSERT_NE(at, track->end());
  EXPECT_EQ(at->where.room, then.room);
  EXPECT_LT(distance(at->where.pose.position, then.pose.position), 1.5);
}

TEST_F(Locate, RefusesARestartInARoomThatIsNotThere) {
  auto log = read_scan_log(prefix_ + ".scans.csv");
  log->restarts.push_back({1.0, "nowhere", std::nullopt, std::nullopt});
  ASSERT_TRUE(write_scan_log(*log, prefix_ + ".scans.csv").ok());
  std::ifstream written(prefix_ + ".scans.csv");
  int line = 1;
  for (std::string text; std::getline(written, text) && text.find("# restart") == std::string::npos;) ++line;
  const ProcessResult result = locate({"--start", start_});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err,
            prefix_ + ".scans.csv:" + std::to_string(line) +
                ": at 1.00 s the walk was started again in room nowhere, which the building does not have\n");
}

TEST_F(Locate, GivesTheSameBytesOnEveryRun) {
  ASSERT_EQ(locate({"--start", start_, "--seed", "9"}).status, 0);
  const std::string first = test::read_file(track_);
  ASSERT_EQ(locate({"--start", start_, "--seed", "9"}).status, 0);
  EXPECT_EQ(test::read_file(track_), first);
}

TEST_F(Locate, BadInputIsNamedAndNothingIsWritten) {
  const std::string broken = folder_.write("broken.csv", "time_s,sensor,range_m\n0.0,0,1.5\n0.1,one,1.5\n").string();
  const ProcessResult result =
      run_echoway({"locate", "--building", kLab, "--scans", broken, "--track", track_});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find(broken + ":3: "), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(track_));
}

TEST_F(Locate, RefusesAFiringOfASensorThatTheBeltDoesNotHave) {
  const std::string log = folder_.write("log.csv", "time_s,sensor,range_m\n0.0,0,1.5\n0.1,15,1.5\n").string();
  const std::vector<std::string> arguments{"locate", "--building", kLab, "--scans", log, "--track", track_};
  const ProcessResult usual = run_echoway(arguments);
  EXPECT_EQ(usual.status, 2);
  EXPECT_NE(usual.err.find(log + ":3: sensor is '15'"), std::string::npos) << usual.err;
  std::vector<std::string> more = arguments;
  more.insert(more.end(), {"--sensors", "16"});
  EXPECT_EQ(run_echoway(more).status, 0);
  EXPECT_EQ(read_track_log(track_)->size(), 2U);
}

TEST_F(Locate, NoOutputTakesThePlaceOfAnotherFile) {
  const std::string scans = prefix_ + ".scans.csv";
  const std::string before = test::read_file(scans);
  for (const std::vector<std::string>& outputs :
       {std::vector<std::string>{"--track", scans}, {"--track", (folder_.path() / "." / "walk.scans.csv").string()},
        {"--track", track_, "--cues", track_}, {"--track", track_, "--cues", scans}}) {
    std::vector<std::string> arguments{"locate", "--building", kLab, "--scans", scans};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    const ProcessResult result = run_echoway(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("name the same file"), std::string::npos) << result.err;
  }
  EXPECT_EQ(test::read_file(scans), before);
  EXPECT_FALSE(std::filesystem::exists(track_));
  EXPECT_EQ(run_echoway({"locate", "--building", kLab, "--scans", scans, "--track", "/dev/null", "--cues", "/dev/null"})
                .status,
            0);
}

TEST_F(Locate, AWholeTrackGoesWhereStandardOutputGoes) {
  ASSERT_EQ(locate({"--start", start_}).status, 0);
  const auto into = folder_.path() / "into.csv";
  const ProcessResult result = run_echoway(
      {"locate", "--building", kLab, "--scans", prefix_ + ".scans.csv", "--start", start_, "--track", "/dev/stdout"},
      {.out = into});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(test::read_file(into), test::read_file(track_));
  EXPECT_NE(result.err.find(" firings, "), std::string::npos)
      << "what was heard and done is said on standard error instead";
}

TEST_F(Locate, BlanksAroundTheFieldsOfAStartMeanNothing) {
  std::string spaced = start_;
  for (std::size_t comma = spaced.find(','); comma != std::string::npos; comma = spaced.find(',', comma + 2)) {
    spaced.insert(comma + 1, " \t");
  }
  spaced.insert(0, "\t ");
  ASSERT_EQ(locate({"--start", start_}).status, 0);
  const std::string track = test::read_file(track_);
  ASSERT_EQ(locate({"--start", spaced}).status, 0);
  EXPECT_EQ(test::read_file(track_), track);
}

TEST_F(Locate, RefusesAStartThatCannotBe) {
  for (const std::string start : {"nowhere,0,0,0", "4,1,x,0", "4,1,2,3,4", "4,1,,0", "4,nan,1,0"}) {
    const ProcessResult result = locate({"--start", start});
    EXPECT_EQ(result.status, 2) << start;
    EXPECT_NE(result.err.find("--start " + start), std::string::npos) << result.err;
  }
}

TEST_F(Locate, SaysToWhichRoomNothingLeads) {
  const TemporaryFolder two;
  two.write("building.cfg", "units m\n");
  for (const char* room : {"room-hall.room", "room-store.room"}) {
    two.write(room, "4 0 0\n1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n");
  }
  const std::string log = folder_.write("log.csv", "time_s,sensor,range_m\n0.0,0,1.5\n").string();
  const auto to = [&](const std::string& goal) {
    return run_echoway({"locate", "--building", two.path().string(), "--scans", log, "--to", goal, "--track", track_});
  };
  EXPECT_EQ(to("store").status, 2);
  EXPECT_NE(to("store").err.find("--to store: nothing leads into room store"), std::string::npos) << to("store").err;
  EXPECT_NE(to("Kitchen").err.find("--to Kitchen: nothing here is called \"Kitchen\""), std::string::npos)
      << to("Kitchen").err;
}

/// A hall and a vault, 4 m square, with a slit of 0.25 m between them, and a cell that no door leads into.
class LocateBeyondASlit : public Locate {
 protected:
  void SetUp() override {
    Locate::SetUp();
    plan_.write("building.cfg", "units m\ndoor hall 4 2 vault 0 2 width 0.25\nplace vault 2 2 \"Safe\"\n");
    for (const char* room : {"room-hall.room", "room-vault.room", "room-cell.room"}) {
      plan_.write(room, "4 0 0\n1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n");
    }
    log_ = folder_.write("log.csv", "time_s,sensor,range_m\n0.0,0,1.5\n0.1,1,1.5\n0.2,2,1.5\n").string();
  }
  [[nodiscard]] ProcessResult to(const std::string& goal, const std::string& start) const {
    std::vector<std::string> arguments{"locate",  "--building", plan_.path().string(), "--scans", log_, "--to", goal,
                                       "--track", track_};
    if (!start.empty()) arguments.insert(arguments.end(), {"--start", start});
    return run_echoway(arguments);
  }
  TemporaryFolder plan_;
  std::string log_;
};

TEST_F(LocateBeyondASlit, NamesTheDoorAndItsWidth) {
  for (const char* goal : {"vault", "Safe"}) {
    for (const char* start : {"", "hall,1,2,0"}) {
      const ProcessResult result = to(goal, start);
      EXPECT_EQ(result.status, 2);
      EXPECT_NE(
          result.err.find(": nothing leads into room vault: the door between rooms 'hall' and 'vault' is 0.25 m wide"),
          std::string::npos)
          << result.err;
    }
  }
}

TEST_F(LocateBeyondASlit, WhoIsThereIsTold) {
  for (const char* goal : {"vault", "cell"}) {
    const ProcessResult result = to(goal, std::string(goal) + ",2,2,0");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
  }
}

TEST_F(Locate, SaysAtOnceThatNoWayLeadsFromTheStart) {
  const TemporaryFolder plan;
  plan.write("building.cfg", "units m\ndoor hall 4 2 vault 0 2 width 0.25\ndoor vault 4 2 cell 0 2 width 0.9\n");
  for (const char* room : {"room-hall.room", "room-vault.room", "room-cell.room"}) {
    plan.write(room, "4 0 0\n1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n");
  }
  const std::string log = folder_.write("log.csv", "time_s,sensor,range_m\n0.0,0,1.5\n").string();
  const auto from = [&](const std::string& start) {
    return run_echoway({"locate", "--building", plan.path().string(), "--scans", log, "--start", start, "--to", "cell",
                        "--track", track_});
  };
  for (const char* start : {"hall", "hall,1,2,0"}) {
    const ProcessResult result = from(start);
    EXPECT_EQ(result.status, 0) << "they are followed all the same";
    EXPECT_EQ(
        result.err,
        "--to cell: no safe way leads from room hall to the destination in room cell: the door between rooms "
        "'hall' and 'vault' is 0.25 m wide, and a person needs 0.4 m\n");
  }
  EXPECT_EQ(from("vault,1,2,0").err, "");
}

TEST_F(Locate, InABuildingOfOneRoomTheWearerIsThereAlready) {
  const TemporaryFolder plan;
  plan.write("building.cfg", "units m\n");
  plan.write("room-hall.room", "4 0 0\n1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n");
  const std::string log = folder_.write("log.csv", "time_s,sensor,range_m\n0.0,0,1.5\n").string();
  const ProcessResult result =
      run_echoway({"locate", "--building", plan.path().string(), "--scans", log, "--to", "hall", "--track", track_});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
}

TEST_F(Locate, RefusesARestartFarOutsideItsRoom) {
  auto log = read_scan_log(prefix_ + ".scans.csv");
  log->restarts.push_back({1.0, "1", Vec2{10.0, 5.0}, std::nullopt});
  ASSERT_TRUE(write_scan_log(*log, prefix_ + ".scans.csv").ok());
  const ProcessResult result = locate({"--start", start_});
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(result.err.starts_with(prefix_ + ".scans.csv:")) << result.err;
  EXPECT_NE(result.err.find(": at 1.00 s the start (10, 5) lies "), std::string::npos) << result.err;
}

TEST_F(Locate, RefusesAStartFarOutsideItsRoomAndSaysWhereTheRoomIs) {
  // Feet where metres are asked for: the room is 3.66 by 4.27 m.
  const ProcessResult far = locate({"--start", "1,10,5,90"});
  EXPECT_EQ(far.status, 2);
  EXPECT_NE(far.err.find("--start 1,10,5,90: the start (10, 5) lies "), std::string::npos) << far.err;
  EXPECT_NE(far.err.find(" m outside room 1, whose floor is between (0, 0) and ("), std::string::npos) << far.err;
  EXPECT_FALSE(std::filesystem::exists(track_));
  EXPECT_EQ(run_echoway({"monitor", "--building", kLab, "--port", "/no/such", "--start", "1,10,5,90"}).err, far.err);
  // Who stands in a doorway has a foot in the next room.
  EXPECT_EQ(locate({"--start", "1,1,-0.4,90"}).status, 0);
}

}  // namespace
}  // namespace echoway
