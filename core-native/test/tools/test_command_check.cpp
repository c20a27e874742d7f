// `echoway check`: exit status and where its findings go.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace echoway::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kSquare = "4 0 0\n1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n";

TEST(CommandCheck, AGoodBuildingSaysNothing) {
  const ProcessResult result = run_echoway({"check", std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out + result.err, IsEmpty());
}

TEST(CommandCheck, WarningsLeaveItUsable) {
  const TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  dir.write("building.cfg", "place A 40 40 \"Moon\"\n");
  const ProcessResult result = run_echoway({"check", dir.path().string()});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, HasSubstr("building.cfg:1: the place at (40, 40) lies outside"));
}

TEST(CommandCheck, AnUnusableBuildingIsStatusTwo) {
  const TemporaryFolder dir;
  dir.write("room-A.room", kSquare);
  dir.write("building.cfg", "A 1 1 B 2 2\n");
  const ProcessResult result = run_echoway({"check", dir.path().string()});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("building.cfg:1: a door leads to room 'B'"));
}

TEST(CommandCheck, NoFolderIsStatusTwo) {
  EXPECT_EQ(run_echoway({"check"}).status, 2);
  const ProcessResult result = run_echoway({"check", "/no/such/folder"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("/no/such/folder: cannot be read"));
}

}  // namespace
}  // namespace echoway::test
