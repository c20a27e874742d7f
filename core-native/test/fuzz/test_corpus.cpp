// Replays what the fuzzers were seeded with and what once broke something, without libFuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "target.hpp"

namespace echoway::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> inputs(const char* folder, std::string_view target) {
  std::vector<fs::path> files;
  const fs::path dir = fs::path(ECHOWAY_FUZZ_DIR) / folder / target;
  if (fs::exists(dir)) {
    for (const auto& entry : fs::directory_iterator(dir)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class FuzzInputs : public testing::TestWithParam<Target> {};

TEST_P(FuzzInputs, KeepEveryPromise) {
  const Target target = GetParam();
  const std::vector<fs::path> corpus = inputs("corpus", target.name);
  ASSERT_FALSE(corpus.empty()) << "no corpus for " << target.name;
  for (const char* folder : {"corpus", "regressions"}) {
    for (const fs::path& file : inputs(folder, target.name)) EXPECT_EQ(target.run(read(file)), "") << file;
  }
}

TEST_P(FuzzInputs, TakeNothingForAnAnswer) { EXPECT_EQ(GetParam().run({}), ""); }

std::string name_of(const testing::TestParamInfo<Target>& parameter) { return std::string(parameter.param.name); }

INSTANTIATE_TEST_SUITE_P(Targets, FuzzInputs, testing::ValuesIn(targets().begin(), targets().end()), name_of);

}  // namespace
}  // namespace echoway::fuzz
