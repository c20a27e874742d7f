#include "source/osm_levels.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "source/limits.hpp"

namespace echoway::import {
namespace {

// Reads one number at `at` and moves behind it. A leading minus belongs to the number.
std::optional<double> read_number(const char*& at) {
  char* rest = nullptr;
  const double value = std::strtod(at, &rest);
  if (rest == at || !std::isfinite(value) || std::abs(value) > kMaxLevels) return std::nullopt;
  at = rest;
  return value;
}

}  // namespace

std::optional<std::vector<double>> parse_osm_levels(const std::string& text) {
  std::vector<double> levels;
  const char* at = text.c_str();
  while (true) {
    const auto first = read_number(at);
    if (!first) return std::nullopt;
    levels.push_back(*first);
    if (*at == '-') {
      ++at;
      const auto last = read_number(at);
      if (!last || *last < *first) return std::nullopt;
      for (double next = *first + 1.0; next <= *last; next += 1.0) levels.push_back(next);
    }
    while (*at == ' ') ++at;
    if (*at == '\0') {
      return levels.size() <= static_cast<std::size_t>(kMaxLevels) ? std::optional(levels) : std::nullopt;
    }
    if (*at != ';') return std::nullopt;
    ++at;
  }
}

std::string osm_level_name(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

}  // namespace echoway::import
