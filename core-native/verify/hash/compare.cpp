#include "hash/compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "echoway/geometry/pose2.hpp"

namespace echoway::tracks {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

double at(const std::vector<std::string>& fields, std::size_t i) { return std::strtod(fields[i].c_str(), nullptr); }

}  // namespace

Difference compare(std::istream& a, std::istream& b) {
  constexpr std::size_t kFields = 6;
  Difference result;
  std::string line_a;
  std::string line_b;
  while (std::getline(a, line_a)) {
    if (!std::getline(b, line_b)) return result;
    const auto one = fields_of(line_a);
    const auto two = fields_of(line_b);
    if (one.size() != kFields || two.size() != kFields || one[0] != two[0]) return result;
    ++result.rows;
    if (one[2] != two[2]) {
      ++result.rooms;
      continue;
    }
    const double apart = std::hypot(at(one, 3) - at(two, 3), at(one, 4) - at(two, 4));
    result.position_m = std::max(result.position_m, apart);
    result.heading_rad = std::max(result.heading_rad, std::fabs(wrap_angle(at(one, 5) - at(two, 5))));
  }
  result.comparable = result.rows > 0 && !std::getline(b, line_b);
  return result;
}

}  // namespace echoway::tracks
