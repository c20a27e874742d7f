#pragma once

#include <string>
#include <string_view>

namespace echoway::stiff {

/// docs/stiff-cases.md: every case, what was expected, what came out, the error and the verdict.
[[nodiscard]] std::string page();

/// Runs every case whose group or name contains `part`, prints those that do not hold and returns how many they are.
int report_failures(std::string_view part);

}  // namespace echoway::stiff
