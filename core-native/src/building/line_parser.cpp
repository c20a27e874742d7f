#include "building/line_parser.hpp"

#include <cmath>

#include "echoway/text/number.hpp"
#include "text/utf8.hpp"

namespace echoway {

std::string shown(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  const bool cut = word.size() > kLongest;
  std::string out(1, '\'');
  out += text::to_utf8(word.substr(0, kLongest));
  out += cut ? "...'" : "'";
  return out;
}

void LineParser::refuse(std::string problem) {
  if (!problem_) problem_ = std::move(problem);
}

const text::Token* LineParser::take(std::string_view what) {
  if (problem_) return nullptr;
  if (at_end()) {
    refuse(std::string(what) + " is missing");
    return nullptr;
  }
  return &tokens_[next_++];
}

std::string LineParser::word(std::string_view what) {
  const text::Token* token = take(what);
  if (token == nullptr) return {};
  if (token->quoted) refuse(std::string(what) + " must be a word without quotes");
  if (!text::is_utf8(token->text)) refuse(std::string(what) + " is not valid UTF-8");
  return token->text;
}

std::string LineParser::quoted(std::string_view what) {
  const text::Token* token = take(what);
  if (token == nullptr) return {};
  if (!token->quoted) refuse(std::string(what) + " must stand in quotes, not as " + shown(token->text));
  return token->text;
}

double LineParser::number(std::string_view what) {
  const text::Token* token = take(what);
  if (token == nullptr) return 0.0;
  const auto value = token->quoted ? std::nullopt : text::parse_number(token->text);
  if (!value) refuse(std::string(what) + " is " + shown(token->text) + ", not a finite number");
  return value.value_or(0.0);
}

long long LineParser::integer(std::string_view what) {
  const text::Token* token = take(what);
  if (token == nullptr) return 0;
  const auto value = token->quoted ? std::nullopt : text::parse_integer(token->text);
  if (!value) refuse(std::string(what) + " is " + shown(token->text) + ", not a whole number");
  return value.value_or(0);
}

double LineParser::length(std::string_view what, double scale) {
  const double metres = number(what) * scale;
  if (std::abs(metres) > kMaxCoordinate) {
    refuse(std::string(what) + " is " + shown(tokens_[next_ - 1].text) + ", too far away for any building");
    return 0.0;
  }
  return metres;
}

Vec2 LineParser::point(double scale) {
  const double x = length("x", scale);
  const double y = length("y", scale);
  return {x, y};
}

Segment LineParser::segment(double scale) {
  const double x1 = length("x1", scale);
  const double y1 = length("y1", scale);
  const double x2 = length("x2", scale);
  const double y2 = length("y2", scale);
  return {{x1, y1}, {x2, y2}};
}

PlaceSource LineParser::place(double scale) {
  PlaceSource out;
  out.room = word("the room");
  out.at = point(scale);
  return out;
}

void LineParser::keyword(std::string_view expected) {
  const text::Token* token = take(expected);
  if (token != nullptr && (token->quoted || token->text != expected)) {
    refuse("expected '" + std::string(expected) + "' instead of " + shown(token->text));
  }
}

void LineParser::end() {
  if (!problem_ && !at_end()) refuse(shown(tokens_[next_].text) + " is one word too many");
}

}  // namespace echoway
