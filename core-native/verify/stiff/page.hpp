#pragma once

#include <string>

namespace echoway::stiff {

/// docs/stiff-cases.md: every case, what was expected, what came out, the error and the verdict.
[[nodiscard]] std::string page();

/// Runs every case, prints those that do not hold and returns how many they are.
int report_failures();

}  // namespace echoway::stiff
