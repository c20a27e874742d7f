#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "echoway/io/atomic_file.hpp"
#include "support/process.hpp"

namespace echoway {
namespace {

using testing::HasSubstr;

std::size_t entries(const std::filesystem::path& dir) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(dir), {}));
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const test::TemporaryFolder dir;
  const auto path = dir.path() / "out.csv";
  Result<AtomicFile> file = AtomicFile::create(path);
  ASSERT_TRUE(file.ok());
  file->write("one\n");
  file->write("two\n");
  EXPECT_FALSE(std::filesystem::exists(path));
  ASSERT_TRUE(file->commit().ok());
  EXPECT_EQ(test::read_file(path), "one\ntwo\n");
  EXPECT_EQ(entries(dir.path()), 1U);
}

TEST(AtomicFile, WithoutCommitWhatWasThereStaysAndNothingIsLeft) {
  const test::TemporaryFolder dir;
  const auto path = dir.write("out.csv", "old");
  {
    Result<AtomicFile> file = AtomicFile::create(path);
    ASSERT_TRUE(file.ok());
    file->write("new");
  }
  EXPECT_EQ(test::read_file(path), "old");
  EXPECT_EQ(entries(dir.path()), 1U);
}

TEST(AtomicFile, AFullDiskLeavesNothingHalfWritten) {
  const test::TemporaryFolder dir;
  const auto path = dir.write("out.csv", "old");
  // The limit on a file's size stands in for the full disk: writing fails half-way in the same manner.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1 << 16, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  Result<AtomicFile> file = AtomicFile::create(path);
  for (int i = 0; i < 100; ++i) file->write(std::string(10'000, 'x'));
  const Status status = file->commit();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().to_string(), HasSubstr("out.csv: cannot be written: "));
  EXPECT_EQ(test::read_file(path), "old");
  EXPECT_EQ(entries(dir.path()), 1U);
}

TEST(AtomicFile, SaysWhyItCannotBeMade) {
  const test::TemporaryFolder dir;
  EXPECT_THAT(AtomicFile::create(dir.path()).error().to_string(), HasSubstr("is a folder"));
  EXPECT_THAT(AtomicFile::create(dir.path() / "no" / "out.csv").error().to_string(), HasSubstr("No such file"));
}

TEST(AtomicFile, WritesToADeviceWithoutReplacingIt) {
  Result<AtomicFile> file = AtomicFile::create("/dev/null");
  ASSERT_TRUE(file.ok());
  file->write("gone");
  EXPECT_TRUE(file->commit().ok());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, FollowsALink) {
  const test::TemporaryFolder dir;
  const auto target = dir.write("target.csv", "old");
  const auto link = dir.path() / "link.csv";
  std::filesystem::create_symlink("target.csv", link);
  Result<AtomicFile> file = AtomicFile::create(link);
  ASSERT_TRUE(file.ok());
  file->write("new");
  ASSERT_TRUE(file->commit().ok());
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(test::read_file(target), "new");
}

TEST(AtomicFile, WritesOnIntoWhatIsOpenAlready) {
  const test::TemporaryFolder dir;
  const auto path = dir.write("out.csv", "before\n");
  const int open = ::open(path.c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(open, 0);
  const std::string number = std::to_string(open);
  const auto link = dir.path() / "link.csv";
  std::filesystem::create_symlink("/dev/fd/" + number, link);
  for (const std::string& name : {"/dev/fd/" + number, "/proc/self/fd/" + number, link.string()}) {
    ASSERT_TRUE(write_file(name, name + "\n").ok()) << name;
  }
  ASSERT_EQ(::write(open, "after\n", 6), 6);
  ::close(open);
  EXPECT_EQ(test::read_file(path),
            "before\n/dev/fd/" + number + "\n/proc/self/fd/" + number + "\n" + link.string() + "\nafter\n");
  EXPECT_THAT(write_file("/dev/fd/" + number, "x").error().to_string(),
              HasSubstr("/dev/fd/" + number + ": cannot be written: "));
}

TEST(AtomicFile, KnowsTheNamesOfOpenFiles) {
  EXPECT_EQ(descriptor_named_by("/dev/stdout"), 1);
  EXPECT_EQ(descriptor_named_by("/dev/../dev/fd/7"), 7);
  for (const char* other : {"/dev/null", "out.csv", "/no/such/fd/1", "/dev/fd", "/dev/fd/x", ""}) {
    EXPECT_EQ(descriptor_named_by(other), std::nullopt) << other;
  }
}

TEST(AtomicFile, IsReadableByWhoeverTheUserAllows) {
  const test::TemporaryFolder dir;
  const mode_t before = umask(022);
  Result<AtomicFile> file = AtomicFile::create(dir.path() / "out.csv");
  ASSERT_TRUE(file->commit().ok());
  umask(before);
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(dir.path() / "out.csv").permissions(),
            perms::owner_read | perms::owner_write | perms::group_read | perms::others_read);
}

}  // namespace
}  // namespace echoway
