#include "stiff/page.hpp"

#include <cstdio>

#include "stiff/case.hpp"

namespace echoway::stiff {
namespace {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

std::string describe_error(const Outcome& outcome) {
  if (outcome.unit == Unit::none) return "";
  const char* const suffix = outcome.unit == Unit::ulps ? " ulp" : outcome.unit == Unit::relative ? " relative" : "";
  return short_number(outcome.error) + suffix + " (allowed " + short_number(outcome.bound) + ")";
}

std::string row(const Case& one, const Outcome& outcome) {
  return "| " + one.name + " | " + outcome.expected + " | " + outcome.got + " | " + describe_error(outcome) + " | " +
         (outcome.holds ? "holds" : "**fails**") + " |\n";
}

}  // namespace

std::string page() {
  std::string body;
  std::string group;
  std::size_t failures = 0;
  for (const Case& one : cases()) {
    if (one.group != group) {
      group = one.group;
      body += "\n## " + group + "\n\n| case | expected | got | error | verdict |\n|---|---|---|---|---|\n";
    }
    const Outcome outcome = one.run();
    failures += outcome.holds ? 0 : 1;
    body += row(one, outcome);
  }
  return "# Stiff and extreme cases\n\nWritten by `make stiff-page` from the table of cases that the tests run "
         "(core-native/verify/stiff), on x86-64 with the release build. Where a row stands for a sweep, the error is "
         "the worst of it and \"got\" says where it was.\n\n" +
         std::to_string(cases().size()) + " cases, " + std::to_string(failures) + " of which do not hold.\n" + body;
}

int report_failures(std::string_view part) {
  int failures = 0;
  int run = 0;
  for (const Case& one : cases()) {
    if ((one.group + ": " + one.name).find(part) == std::string::npos) continue;
    ++run;
    const Outcome outcome = one.run();
    if (outcome.holds) continue;
    ++failures;
    std::printf("FAILED %s: %s: expected %s, got %s %s\n", one.group.c_str(), one.name.c_str(),
                outcome.expected.c_str(), outcome.got.c_str(), describe_error(outcome).c_str());
  }
  std::printf("%d stiff cases, %d failed\n", run, failures);
  return failures;
}

}  // namespace echoway::stiff
