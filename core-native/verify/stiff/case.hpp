#pragma once

#include <functional>
#include <string>
#include <vector>

/// Stiff and extreme cases. One table serves the tests and the page docs/stiff-cases.md, so that they cannot disagree.
namespace echoway::stiff {

enum class Unit {
  none,      ///< Holds or does not; nothing to measure.
  absolute,  ///< In the quantity's own unit.
  relative,
  ulps,      ///< Of the expected value.
};

/// What came out of a case.
struct Outcome {
  std::string expected;
  std::string got;
  Unit unit = Unit::none;
  double error = 0.0;  ///< In `unit`.
  double bound = 0.0;  ///< Largest error that is allowed.
  bool holds = false;  ///< The verdict.
};

struct Case {
  std::string group;  ///< Heading on the page.
  std::string name;
  std::function<Outcome()> run;
};

/// A measured error against its bound; NaN does not hold.
[[nodiscard]] Outcome within(double expected, double got, Unit unit, double bound);
/// The worst of many, measured elsewhere: `got` says where it was.
[[nodiscard]] Outcome worst(std::string expected, double error, Unit unit, double bound, std::string where = {});
/// Something that is so or is not.
[[nodiscard]] Outcome holds(std::string expected, bool does, std::string got);

/// Seventeen significant digits only where they are needed: the shortest of %.3g, %.6g and %.17g that reads back.
[[nodiscard]] std::string number(double value);

/// The larger of two errors, with NaN the largest of all, so that it cannot hide in a maximum.
[[nodiscard]] double larger(double a, double b);

// The table, group by group.
void add_acoustics(std::vector<Case>& table);
void add_echo_times(std::vector<Case>& table);
void add_geometry(std::vector<Case>& table);
void add_plans(std::vector<Case>& table);
void add_estimation(std::vector<Case>& table);
void add_conditioning(std::vector<Case>& table);

/// Every case.
[[nodiscard]] const std::vector<Case>& cases();

}  // namespace echoway::stiff
