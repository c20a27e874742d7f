// How the sources are written, of the core, of the app and of its build.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace echoway {
namespace {

namespace fs = std::filesystem;

constexpr std::ptrdiff_t kColumns = 120;  // As .clang-format says; Kotlin and Java have the same.

const fs::path kRoot = ECHOWAY_ROOT_DIR;

bool is_source(const fs::path& file) {
  const std::string extension = file.extension().string();
  constexpr std::array kSources{".cpp", ".hpp", ".java", ".kt", ".kts"};
  return std::ranges::find(kSources, extension) != kSources.end();
}

/// Characters of a line in UTF-8, which goes on in bytes that begin with the bits 10.
std::ptrdiff_t columns(const std::string& line) {
  return std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

/// `file:line` of each that is too long.
std::vector<std::string> long_lines(const fs::path& folder) {
  std::vector<std::string> found;
  for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator(); ++entry) {
    if (entry->is_directory() && entry->path().filename() == "build") entry.disable_recursion_pending();
    if (!entry->is_regular_file() || !is_source(entry->path())) continue;
    const std::string name = fs::relative(entry->path(), kRoot).generic_string();
    std::ifstream in(entry->path());
    int number = 0;
    for (std::string line; std::getline(in, line);) {
      ++number;
      const bool can_be_broken = !line.starts_with("import ");
      if (can_be_broken && columns(line) > kColumns) found.push_back(name + ":" + std::to_string(number));
    }
  }
  return found;
}

TEST(SourceLines, FitIn120Columns) {
  for (const char* folder : {"core-native", "app", "tools"}) {
    EXPECT_THAT(long_lines(kRoot / folder), testing::IsEmpty());
  }
}

}  // namespace
}  // namespace echoway
