// Numbers, words and lines of our text files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>

#include "support/process.hpp"
#include "text/format.hpp"
#include "echoway/text/line_reader.hpp"
#include "echoway/text/number.hpp"
#include "echoway/text/tokens.hpp"
#include "text/utf8.hpp"

namespace echoway::text {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ParseNumber, TakesDecimalNumbers) {
  EXPECT_EQ(parse_number("6.45"), 6.45);
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("+3"), 3.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("1e-3"), 1e-3);
  EXPECT_EQ(parse_number("1e-400"), 0.0);
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* token : {"",       " ",   "1 ",    " 1", "1x", "0x10", "nan", "inf", "-inf", "infinity", "1e999",
                            "-1e999", "1,5", "1.2.3", "e5", "1e", "1e+",  ".",   "+",   "--1",  "1_000",    "1d5"}) {
    EXPECT_FALSE(parse_number(token).has_value()) << token;
  }
  EXPECT_FALSE(parse_number(std::string_view("1\0", 2)).has_value());
  EXPECT_FALSE(parse_number(std::string(1'000'000, '9')).has_value());
}

TEST(ParseNumber, ReadsAPointWhateverTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, locale);
    EXPECT_EQ(parse_number("2.5"), 2.5) << locale;
    std::string out;
    append_number(out, 2.5, 2);
    EXPECT_EQ(out, "2.5") << locale;
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ParseInteger, TakesWholeNumbersThatFit) {
  EXPECT_EQ(parse_integer("15"), 15);
  EXPECT_EQ(parse_integer("-3"), -3);
  EXPECT_EQ(parse_integer("+3"), 3);
  for (const char* token : {"", "+", "-", "1.0", "1e3", "99999999999999999999", "0x1", "+-1", " 1"}) {
    EXPECT_FALSE(parse_integer(token).has_value()) << token;
  }
}

std::string written(double value, int decimals) {
  std::string out;
  append_number(out, value, decimals);
  return out;
}

TEST(AppendNumber, WritesNoMoreThanItNeeds) {
  EXPECT_EQ(written(0.0624, 6), "0.0624");
  EXPECT_EQ(written(-12.5, 4), "-12.5");
  EXPECT_EQ(written(3.0, 4), "3");
  EXPECT_EQ(written(-0.00001, 4), "0");
  EXPECT_EQ(written(1.99999, 4), "2");
  EXPECT_EQ(written(1.0 / 3.0, 0), "0");
  EXPECT_EQ(written(1.7e9 + 0.0625, 6), "1700000000.0625");
}

std::vector<std::string> words(std::string_view line) {
  std::vector<std::string> out;
  const auto tokens = split_tokens(line);
  if (!tokens) return {"(open quote)"};
  for (const Token& token : *tokens) out.push_back(token.quoted ? "\"" + token.text : token.text);
  return out;
}

TEST(SplitTokens, KnowsQuotesAndComments) {
  EXPECT_THAT(words("place R 1 2 \"Front desk\"  # here"), ElementsAre("place", "R", "1", "2", "\"Front desk"));
  EXPECT_THAT(words("a\t b#c"), ElementsAre("a", "b"));
  EXPECT_THAT(words("\"# no comment\""), ElementsAre("\"# no comment"));
  EXPECT_THAT(words("\"a \\\"b\\\" \\\\ c\\d\""), ElementsAre("\"a \"b\" \\ c\\d"));
  EXPECT_THAT(words("\"open"), ElementsAre("(open quote)"));
  EXPECT_THAT(words("\"open\\\""), ElementsAre("(open quote)"));
  EXPECT_THAT(words("\"\""), ElementsAre("\""));
}

TEST(Quote, IsUndoneBySplitting) {
  for (const std::string name : {"Lectern", "say \"hi\"", "back\\slash", "ends in \\", "# 1", ""}) {
    EXPECT_THAT(words(quote(name)), ElementsAre("\"" + name));
  }
}

TEST(Utf8, IsToldFromEverythingElse) {
  EXPECT_TRUE(is_utf8("Zimmer \xC3\xBC, \xE6\x95\x99\xE5\xAE\xA4, \xF0\x9F\x9A\xAA"));
  for (const char* bad :
       {"\xFC", "\xC3", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80", "a\xE6\x95"}) {
    EXPECT_FALSE(is_utf8(bad));
    EXPECT_TRUE(is_utf8(to_utf8(bad)));
  }
  EXPECT_EQ(to_utf8("B\xFCro"), "B?ro");
}

std::vector<std::string> lines_of(std::string_view text) {
  const test::TemporaryFolder dir;
  Result<LineReader> reader = LineReader::open(dir.write("f", text));
  std::vector<std::string> out;
  while (const auto line = reader->next()) out.emplace_back(*line);
  if (reader->error())
    out.push_back("error " + std::to_string(reader->error()->line) + ": " + reader->error()->message);
  return out;
}

TEST(LineReader, EndsLinesAsAnySystemDoes) {
  EXPECT_THAT(lines_of("a\nb\n"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_of("a\r\nb\r\n"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_of("a\n\nb"), ElementsAre("a", "", "b"));
  EXPECT_THAT(lines_of("\xEF\xBB\xBF"
                       "a\nb"),
              ElementsAre("a", "b"));
  EXPECT_THAT(lines_of(""), ElementsAre());
}

TEST(LineReader, CarriesLinesAcrossItsBuffer) {
  std::string text;
  for (int i = 0; i < 40'000; ++i) text += std::to_string(i) + '\n';
  const auto lines = lines_of(text);
  ASSERT_EQ(lines.size(), 40'000U);
  for (int i = 0; i < 40'000; ++i) ASSERT_EQ(lines[static_cast<std::size_t>(i)], std::to_string(i));
}

TEST(LineReader, StopsAtWhatIsNoText) {
  EXPECT_THAT(lines_of("a\n" + std::string(5000, 'x') + "\nb\n"),
              ElementsAre("a", HasSubstr("error 2: line is longer")));
  EXPECT_THAT(lines_of(std::string(200'000, 'x')), ElementsAre(HasSubstr("error 1: line is longer")));
  EXPECT_THAT(lines_of(std::string("a\n\0b\n", 5)), ElementsAre("a", HasSubstr("error 2: holds control characters")));
}

TEST(LineReader, SaysWhyAFileCannotBeRead) {
  const test::TemporaryFolder dir;
  EXPECT_THAT(LineReader::open(dir.path()).error().to_string(), HasSubstr("is a folder"));
  EXPECT_THAT(LineReader::open(dir.path() / "none").error().to_string(), HasSubstr("none: cannot be opened: No such"));
}

}  // namespace
}  // namespace echoway::text
