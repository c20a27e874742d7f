// Every row of docs/faults.md, every n-th byte for all n, and what a full disk or a cut log leaves.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "echoway/io/logs.hpp"
#include "faults/fault.hpp"
#include "support/temp_dir.hpp"

namespace echoway::faults {

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

namespace {

namespace fs = std::filesystem;

class FaultInjection : public testing::TestWithParam<Fault> {};

TEST_P(FaultInjection, ComesToWhatTheTableSays) { EXPECT_EQ(verdict(GetParam(), run(GetParam())), ""); }

std::string name_of(const testing::TestParamInfo<Fault>& parameter) {
  std::string name = std::to_string(parameter.index) + "_";
  for (const char c : parameter.param.name) {
    if (std::isalnum(static_cast<unsigned char>(c))) {
      name += c;
    } else if (name.back() != '_') {
      name += '_';
    }
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Table, FaultInjection, testing::ValuesIn(table()), name_of);

TEST(FaultInjection, NoCorruptionOfEachNthByteInventsAFiring) {
  const Events sent = sentences_of(walk());
  for (int n = 2; n <= 1000; ++n) {
    for (void (*corrupt)(Events&, int) : {lose_each, double_each, flip_each}) {
      Events events = sent;
      corrupt(events, n);
      ASSERT_EQ(invented(events, sent), 0) << "n = " << n;
    }
  }
}

TEST(FaultsPage, ListsEveryFault) {
  std::ifstream in(ECHOWAY_DOCS_DIR "/faults.md");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  for (const Fault& fault : table()) {
    EXPECT_NE(page.find("| " + fault.name + " |"), std::string::npos)
        << fault.name << " is missing: run make faults-page";
  }
}

ScanLog long_log() {
  ScanLog log;
  for (int i = 0; i < 2000; ++i) log.firings.push_back({0.0624 * i, i % 15, 1.0 + 0.001 * i});
  return log;
}

/// Writes in a process of its own that may write no more than 4 KiB to a file. Returns whether it reported an error.
bool write_with_full_disk(const fs::path& file) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(2);
    _exit(write_scan_log(long_log(), file) ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

std::size_t files_in(const fs::path& dir) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(dir), fs::directory_iterator()));
}

TEST(DiskFull, LeavesNothingHalfWritten) {
  const test::TempDir dir;
  EXPECT_TRUE(write_with_full_disk(dir.path() / "walk.scans.csv"));
  EXPECT_EQ(files_in(dir.path()), 0U);
}

TEST(DiskFull, KeepsTheLogThatWasThereBefore) {
  const test::TempDir dir;
  const fs::path file = dir.path() / "walk.scans.csv";
  ScanLog before;
  before.firings = {{0.0, 0, 1.25}, {0.0624, 1, Firing::kNoEcho}};
  ASSERT_TRUE(write_scan_log(before, file));
  EXPECT_TRUE(write_with_full_disk(file));
  const Result<ScanLog> kept = read_scan_log(file);
  ASSERT_TRUE(kept.ok());
  EXPECT_EQ(kept->firings.size(), 2U);
  EXPECT_EQ(files_in(dir.path()), 1U);
}

TEST(DiskFull, IsReportedForADeviceToo) { EXPECT_FALSE(write_scan_log(long_log(), "/dev/full").ok()); }

/// A log's rows when it is read, whatever it holds; nothing when it is refused.
using CountRows = std::optional<std::size_t> (*)(const fs::path&);
struct LogKind {
  const char* name;
  const char* header;
  const char* row;  ///< Behind its time.
  CountRows rows;
};

void PrintTo(const LogKind& kind, std::ostream* out) { *out << kind.name; }

template <class Log>
std::optional<std::size_t> size_of(const Result<std::vector<Log>>& log) {
  return log ? std::optional(log->size()) : std::nullopt;
}

const LogKind kLogKinds[] = {
    {"scans", "# sensors 15\ntime_s,sensor,range_m\n", ",3,2.125",
     [](const fs::path& file) {
       const Result<ScanLog> log = read_scan_log(file);
       return log ? std::optional(log->firings.size()) : std::nullopt;
     }},
    {"silences", "time_s,sensor,range_m\n", ",3,",
     [](const fs::path& file) {
       const Result<ScanLog> log = read_scan_log(file);
       return log ? std::optional(log->firings.size()) : std::nullopt;
     }},
    {"motion", "time_s,kind,value\n", ",yaw_rate_dps,-2.5",
     [](const fs::path& file) { return size_of(read_motion_log(file)); }},
    {"truth", "time_s,room,x_m,y_m,heading_deg\n", ",hall,1.5,2,90",
     [](const fs::path& file) { return size_of(read_truth_log(file)); }},
    {"track", "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n", ",hall,1.5,2,90,0.1,0.99,tracking",
     [](const fs::path& file) { return size_of(read_track_log(file)); }},
};

class CutLog : public testing::TestWithParam<LogKind> {};

TEST_P(CutLog, IsReadUpToItsLastWholeRowWhereverItIsCut) {
  const LogKind& kind = GetParam();
  const std::string header = kind.header;
  std::string text = header;
  for (int i = 0; i < 12; ++i) text += std::to_string(0.0625 * i) + kind.row + "\n";
  const test::TempDir dir;
  const fs::path file = dir.path() / "cut.csv";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    const std::string kept = text.substr(0, cut);
    std::ofstream(file, std::ios::binary) << kept;
    const std::optional<std::size_t> rows = kind.rows(file);
    if (cut + 1 < header.size()) {
      EXPECT_FALSE(rows) << "without its header, cut at " << cut;
      continue;
    }
    ASSERT_TRUE(rows) << "cut at " << cut;
    const auto whole = cut < header.size()
                           ? 0U
                           : static_cast<std::size_t>(std::count(
                                 kept.begin() + static_cast<std::ptrdiff_t>(header.size()), kept.end(), '\n'));
    EXPECT_GE(*rows, whole) << "cut at " << cut;
    EXPECT_LE(*rows, whole + 1) << "cut at " << cut;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CutLog, testing::ValuesIn(kLogKinds),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace echoway::faults
