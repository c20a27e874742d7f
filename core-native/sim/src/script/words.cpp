#include "script/words.hpp"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "echoway/text/number.hpp"

namespace echoway::sim {
namespace {

std::string shown(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

}  // namespace

Words::Words(std::string_view line, const std::string& file, int number) : file_(file), number_(number) {
  std::string word;
  for (const char c : line) {
    if (c == '#') break;
    if (c == ' ' || c == '\t' || c == '\r') {
      if (!word.empty()) words_.push_back(std::move(word));
      word.clear();
    } else {
      word += c;
    }
  }
  if (!word.empty()) words_.push_back(std::move(word));
}

std::string Words::keyword() { return words_[next_++]; }

Status Words::text(std::string_view what, std::string& out) {
  if (next_ >= words_.size()) return error("`" + words_[0] + "` lacks " + std::string(what));
  out = words_[next_++];
  return success();
}

Status Words::number(std::string_view what, double low, double high, double& out) {
  std::string word;
  if (Status status = text(what, word); !status.ok()) return status;
  const std::optional<double> value = echoway::text::parse_number(word);
  if (!value) return error("`" + word + "` is no number (" + std::string(what) + ")");
  if (*value < low || *value > high) {
    return error(std::string(what) + " must be from " + shown(low) + " to " + shown(high) + ", not " + word);
  }
  out = *value;
  return success();
}

Status Words::integer(std::string_view what, int low, int high, int& out) {
  double value = 0.0;
  if (Status status = number(what, low, high, value); !status.ok()) return status;
  if (value != std::floor(value)) return error(std::string(what) + " must be a whole number");
  out = static_cast<int>(value);
  return success();
}

Status Words::seed(std::uint64_t& out) {
  std::string word;
  if (Status status = text("a number", word); !status.ok()) return status;
  if (word.find_first_not_of("0123456789") != std::string::npos) return error("a seed is a whole number, not " + word);
  errno = 0;
  out = std::strtoull(word.c_str(), nullptr, 10);
  return errno == ERANGE ? Status(error("the seed is too large")) : success();
}

Status Words::sensors(int count, std::vector<int>& out) {
  std::string word;
  if (Status status = text("sensors (0,1,14 or all)", word); !status.ok()) return status;
  out.clear();
  if (word == "all") return success();
  std::size_t begin = 0;
  while (begin <= word.size()) {
    const std::size_t end = std::min(word.find(',', begin), word.size());
    const std::string item = word.substr(begin, end - begin);
    const bool digits = !item.empty() && item.size() < 5 && item.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || std::atoi(item.c_str()) >= count) {
      return error("`" + item + "` is no sensor of this belt; they count from 0 to " + std::to_string(count - 1));
    }
    out.push_back(std::atoi(item.c_str()));
    begin = end + 1;
  }
  return success();
}

Status Words::finish() const {
  if (next_ < words_.size()) return error("`" + words_[next_] + "` is one word too many for `" + words_[0] + "`");
  return success();
}

}  // namespace echoway::sim
