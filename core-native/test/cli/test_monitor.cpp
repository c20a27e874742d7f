#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/process.hpp"

namespace echoway {
namespace {

using test::BackgroundEchoway;
using test::run_echoway;
using test::TemporaryFolder;

const std::string kLab = std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab";

TEST(Monitor, FollowsABeltOnAPseudoTerminalFromConnectionToLoss) {
  const TemporaryFolder folder;
  const std::string prefix = (folder.path() / "still").string();
  ASSERT_EQ(run_echoway({"simulate", "--building", kLab, "--random", "4", "--profile", "empty", "--seed", "5", "--out", prefix})
                .status, 0);
  const std::string truth = test::read_file(prefix + ".truth.csv");
  const std::string first = truth.substr(truth.find('\n') + 1);
  const std::string start = first.substr(first.find(',') + 1, first.find('\n') - first.find(',') - 1);
  const std::string room = start.substr(0, start.find(','));

  BackgroundEchoway belt({"play", "--scans", prefix + ".scans.csv", "--speed", "20"});
  const std::string port = belt.read_line();
  ASSERT_FALSE(port.empty());
  BackgroundEchoway monitor({"monitor", "--building", kLab, "--port", port, "--start", start});
  std::string heard;
  for (std::string line = monitor.read_line(); !line.empty(); line = monitor.read_line()) {
    heard += line + "\n";
    if (line.find("sentences; dropped") != std::string::npos) break;
  }
  EXPECT_EQ(heard.find("Belt connected.\n"), 0U) << heard;
  EXPECT_NE(heard.find("room " + room), std::string::npos) << heard;
  EXPECT_NE(heard.find("Belt disconnected.\n"), std::string::npos) << heard;
  const std::string scans = test::read_file(prefix + ".scans.csv");
  const auto firings = std::count_if(scans.begin() + static_cast<std::ptrdiff_t>(scans.find("time_s")), scans.end(),
                                     [](char c) { return c == '\n'; }) - 1;
  EXPECT_NE(heard.find(std::to_string(firings) + " sentences; dropped 0 with a bad checksum, 0 malformed; 0 firings lost\n"),
            std::string::npos)
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
