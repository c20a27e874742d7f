#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "echoway/io/logs.hpp"
#include "support/process.hpp"

namespace echoway {
namespace {

using test::BackgroundEchoway;
using test::run_echoway;
using test::TemporaryFolder;

const std::string kLab = std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab";

// What it says until all of `parts` are heard, or it ends.
std::string read_until(BackgroundEchoway& process, const std::vector<std::string>& parts) {
  std::string heard;
  for (std::string line = process.read_line(); !line.empty(); line = process.read_line()) {
    heard += line + "\n";
    const auto is_heard = [&](const std::string& part) { return heard.find(part) != std::string::npos; };
    if (std::all_of(parts.begin(), parts.end(), is_heard)) break;
  }
  return heard;
}

// Each firing, and what the belt says of itself once a second.
void expect_all_heard(const std::string& heard, const ScanLog& log) {
  const auto sentences =
      log.firings.size() + static_cast<std::size_t>(log.firings.back().time_s - log.firings.front().time_s) + 1;
  EXPECT_NE(heard.find(std::to_string(sentences) +
                       " sentences; dropped 0 with a bad checksum, 0 malformed; 0 firings lost\n"),
            std::string::npos)
      << heard;
}

TEST(Monitor, FollowsABeltOnAPseudoTerminalFromConnectionToLoss) {
  const TemporaryFolder folder;
  const std::string prefix = (folder.path() / "still").string();
  ASSERT_EQ(run_echoway(
                {"simulate", "--building", kLab, "--random", "4", "--profile", "empty", "--seed", "5", "--out", prefix})
                .status,
            0);
  const std::string truth = test::read_file(prefix + ".truth.csv");
  const std::string first = truth.substr(truth.find('\n') + 1);
  const std::string start = first.substr(first.find(',') + 1, first.find('\n') - first.find(',') - 1);
  const std::string room = start.substr(0, start.find(','));

  BackgroundEchoway belt({"play", "--scans", prefix + ".scans.csv", "--speed", "20"});
  const std::string port = belt.read_line();
  ASSERT_FALSE(port.empty());
  BackgroundEchoway monitor({"monitor", "--building", kLab, "--port", port, "--start", start});
  const std::string heard = read_until(monitor, {"Belt disconnected.\n", "sentences; dropped"});
  EXPECT_EQ(heard.find("Belt connected.\n"), 0U) << heard;
  EXPECT_NE(heard.find("room " + room), std::string::npos) << heard;
  // At once, or when the line before is said.
  EXPECT_NE(heard.find("Belt disconnected.\n"), std::string::npos) << heard;
  const auto log = read_scan_log(prefix + ".scans.csv");
  ASSERT_TRUE(log.ok());
  expect_all_heard(heard, *log);
}

// A recording that is sent to the port as fast as it takes it, which is more than the line holds. How it is followed:
// test_live_belt.cpp.
TEST(Monitor, LosesNothingOfAWalkThatComesFarFasterThanABeltFires) {
  const TemporaryFolder folder;
  const std::string walk = kLab + "/walks/thesis.walk";
  const std::string prefix = (folder.path() / "walk").string();
  ASSERT_EQ(run_echoway({"simulate", "--walk", walk, "--out", prefix}).status, 0);
  const auto log = read_scan_log(prefix + ".scans.csv");
  ASSERT_TRUE(log.ok());
  BackgroundEchoway belt({"play", "--scans", prefix + ".scans.csv", "--speed", "1000"});
  BackgroundEchoway monitor({"monitor", "--building", kLab, "--port", belt.read_line()});
  expect_all_heard(read_until(monitor, {"sentences; dropped"}), *log);
}

TEST(Play, EndsWhenNobodyReads) {
  const TemporaryFolder folder;
  std::string rows = "time_s,sensor,range_m\n";
  for (int i = 0; i < 20'000; ++i) rows += std::to_string(0.001 * i) + ",0,1.5\n";  // More than a line holds.
  const std::string log = folder.write("log.csv", rows).string();
  const test::ProcessResult played = run_echoway({"play", "--scans", log, "--speed", "1000", "--patience", "0.2"});
  EXPECT_EQ(played.status, 2);
  EXPECT_NE(played.err.find(": nobody reads the terminal"), std::string::npos) << played.err;
}

TEST(Play, SaysSoWhenNobodyReadsWhatTheLineHolds) {
  const TemporaryFolder folder;
  const std::string log = folder.write("log.csv", "time_s,sensor,range_m\n0,0,1.5\n").string();
  const test::ProcessResult played = run_echoway({"play", "--scans", log, "--patience", "0.2"});
  EXPECT_EQ(played.status, 2);
  EXPECT_NE(played.err.find(": nobody reads the terminal"), std::string::npos) << played.err;
}

TEST(Play, LosesNothingToAListenerWhoIsSlow) {
  const TemporaryFolder folder;
  std::string rows = "time_s,sensor,range_m\n";
  for (int i = 0; i < 100; ++i) rows += std::to_string(0.001 * i) + ",0,1.5\n";  // The line holds all of it.
  const std::string log = folder.write("log.csv", rows).string();
  BackgroundEchoway belt({"play", "--scans", log, "--patience", "86400"});
  const int port = open(belt.read_line().c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(port, 0);
  std::this_thread::sleep_for(std::chrono::seconds(2));  // All is sent by then, on an idle machine.
  std::string heard;
  char buffer[1000];
  for (ssize_t count = read(port, buffer, sizeof buffer); count > 0; count = read(port, buffer, sizeof buffer)) {
    heard.append(buffer, static_cast<std::size_t>(count));
  }
  close(port);
  EXPECT_EQ(std::count(heard.begin(), heard.end(), '$'), 101);  // Each firing, and once what the belt says of itself.
}

// The name of a terminal that hung up goes to the next one, which may be a shell's.
TEST(Monitor, LeavesAloneWhoeverGetsTheTerminalsNameNext) {
  const TemporaryFolder folder;
  const std::string log = folder.write("log.csv", "time_s,sensor,range_m\n0,0,1.5\n0.1,1,1.5\n").string();
  BackgroundEchoway belt({"play", "--scans", log});
  const std::string port = belt.read_line();
  BackgroundEchoway monitor({"monitor", "--building", kLab, "--port", port});
  EXPECT_NE(read_until(monitor, {"sentences; dropped"}).find("3 sentences; dropped 0"), std::string::npos);

  BackgroundEchoway other({"play", "--scans", log});
  if (other.read_line() != port) GTEST_SKIP() << "another program has got " << port;
  const std::string rest = read_until(monitor, {"sentences; dropped"});
  EXPECT_EQ(rest.find("sentences; dropped"), std::string::npos) << rest;
}

TEST(Monitor, RefusesABeltOfAnotherNumberOfSensorsThanIsThought) {
  const TemporaryFolder folder;
  const std::string log =
      folder.write("log.csv", "# sensors 4\ntime_s,sensor,range_m\n0,0,1.5\n0.1,1,1.5\n0.2,2,1.5\n").string();
  BackgroundEchoway belt({"play", "--scans", log});
  const auto refused = run_echoway({"monitor", "--building", kLab, "--port", belt.read_line()});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("the belt says that it has 4 sensors, not 15; give --sensors 4"), std::string::npos)
      << refused.err;

  BackgroundEchoway again({"play", "--scans", log});
  BackgroundEchoway followed({"monitor", "--building", kLab, "--port", again.read_line(), "--sensors", "4"});
  EXPECT_NE(read_until(followed, {"sentences; dropped"}).find("4 sentences; dropped 0"), std::string::npos);
}

TEST(Monitor, HearsNothingWhereALogHasAnEchoFromBeyondWhatASentenceHolds) {
  const TemporaryFolder folder;
  const std::string log = folder.write("log.csv", "time_s,sensor,range_m\n0,0,9000\n0.1,1,1.5\n0.2,2,400\n").string();
  BackgroundEchoway belt({"play", "--scans", log});
  BackgroundEchoway monitor({"monitor", "--building", kLab, "--port", belt.read_line()});
  const std::string heard = read_until(monitor, {"sentences; dropped"});
  EXPECT_NE(heard.find("4 sentences; dropped 0 with a bad checksum, 0 malformed; 0 firings lost\n"), std::string::npos)
      << heard;
}

TEST(Monitor, SaysWhatIsWrongWithAPort) {
  const auto missing = run_echoway({"monitor", "--building", kLab, "--port", "/no/such/port"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("/no/such/port"), std::string::npos);
  const auto file = run_echoway({"monitor", "--building", kLab, "--port", kLab + "/building.cfg"});
  EXPECT_EQ(file.status, 2);
  EXPECT_NE(file.err.find("not a serial port"), std::string::npos) << file.err;
}

}  // namespace
}  // namespace echoway
