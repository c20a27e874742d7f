#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "support/process.hpp"

namespace echoway {
namespace {

using test::run_echoway;

const std::string kMaps = ECHOWAY_MAPS_DIR;

// The line of the table that begins with `room`.
std::string line_of(const std::string& table, const std::string& room) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(room + " ")) return line;
  }
  return {};
}

// What stands below `column` of the table, whose heads end where its entries do.
std::string cell(const std::string& table, const std::string& room, const std::string& column) {
  const std::string head = line_of(table, "room");
  const std::size_t end = head.find(column) + column.size();
  const std::string line = line_of(table, room).substr(0, end);
  const std::size_t gap = line.rfind("  ");
  return line.substr(gap + 2);
}

TEST(Describe, SaysOfEveryRoomWhatIsLeftOut) {
  const auto result = run_echoway({"describe", kMaps + "/torgersen-lab", "--left-out"});
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* room : {"1", "2", "3", "4", "5", "6", "hall"}) {
    EXPECT_NE(line_of(result.out, room), "") << room << "\n" << result.out;
  }
  // Benches stand in rooms 3 and 6: next door they are heard, from the front office nobody hears any.
  EXPECT_EQ(cell(result.out, "1", "all-reflective"), "-") << result.out;
  EXPECT_EQ(cell(result.out, "3", "all-reflective"), "14 of 14") << result.out;
  EXPECT_NE(result.out.find("all-reflective elements in 2 of 7 rooms"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("as there is one level"), std::string::npos) << result.out;
}

TEST(Describe, OfSeveralLevelsNoStairsAreLeftOut) {
  const test::TemporaryFolder folder;
  folder.write("building.cfg", "units m\nroom up level 1\nstairs down 1 1 up 1 1\n");
  for (const char* room : {"room-up.room", "room-down.room"}) {
    folder.write(room, "4 0 0\n1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n");
  }
  const auto result = run_echoway({"describe", folder.path().string(), "--left-out"});
  EXPECT_NE(result.out.find("several levels"), std::string::npos) << result.out << result.err;
}

TEST(Describe, RefusesABuildingThatIsNone) {
  for (const auto& arguments :
       {std::vector<std::string>{"describe", "/no/such"}, {"describe", "/no/such", "--left-out"}}) {
    const auto result = run_echoway(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("/no/such: "), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace echoway
