#include "stiff/case.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

namespace echoway::stiff {
namespace {

double error_in(Unit unit, double expected, double got) {
  const double difference = std::fabs(got - expected);
  switch (unit) {
    case Unit::relative: return expected == 0.0 ? difference : difference / std::fabs(expected);
    case Unit::ulps: {
      const double size = std::fabs(expected);
      return difference / (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
    }
    case Unit::none:
    case Unit::absolute: break;
  }
  return difference;
}

}  // namespace

std::string number(double value) {
  char text[40];
  for (const char* format : {"%.3g", "%.6g", "%.17g"}) {
    std::snprintf(text, sizeof text, format, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

double larger(double a, double b) {
  if (std::isnan(a)) return a;
  return b <= a ? a : b;
}

Outcome within(double expected, double got, Unit unit, double bound) {
  const double error = error_in(unit, expected, got);
  return {number(expected), number(got), unit, error, bound, error <= bound};
}

Outcome worst(std::string expected, double error, Unit unit, double bound, std::string where) {
  return {std::move(expected), std::move(where), unit, error, bound, error <= bound};
}

Outcome holds(std::string expected, bool does, std::string got) {
  return {std::move(expected), std::move(got), Unit::none, 0.0, 0.0, does};
}

const std::vector<Case>& cases() {
  static const std::vector<Case> table = [] {
    std::vector<Case> all;
    add_acoustics(all);
    add_echo_times(all);
    add_geometry(all);
    add_plans(all);
    add_estimation(all);
    add_conditioning(all);
    return all;
  }();
  return table;
}

}  // namespace echoway::stiff
