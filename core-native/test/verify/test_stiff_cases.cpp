// Every row of docs/stiff-cases.md is a test.
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>

#include "stiff/case.hpp"

namespace echoway::stiff {

void PrintTo(const Case& one, std::ostream* out) { *out << one.group << ": " << one.name; }

namespace {

class StiffCase : public testing::TestWithParam<Case> {};

TEST_P(StiffCase, Holds) {
  const Outcome outcome = GetParam().run();
  EXPECT_TRUE(outcome.holds) << "expected " << outcome.expected << ", got " << outcome.got << ", error "
                             << outcome.error << " of " << outcome.bound << " allowed";
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name = std::to_string(info.index) + "_";
  for (const char c : info.param.group + "_" + info.param.name) {
    if (std::isalnum(static_cast<unsigned char>(c))) {
      name += c;
    } else if (name.back() != '_') {
      name += '_';
    }
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Table, StiffCase, testing::ValuesIn(cases()), name_of);

TEST(StiffCasesPage, ListsEveryCase) {
  std::ifstream in(ECHOWAY_DOCS_DIR "/stiff-cases.md");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  for (const Case& one : cases()) {
    EXPECT_NE(page.find("| " + one.name + " |"), std::string::npos) << one.name << " is missing: run make stiff-page";
  }
}

}  // namespace
}  // namespace echoway::stiff
