#pragma once

#include <filesystem>

#include "building/findings.hpp"
#include "building/source.hpp"

namespace echoway {

/// Reads building.cfg (docs/formats.md). A building without one is taken in feet, without doors, and a warning says so.
[[nodiscard]] ConfigSource read_config_file(const std::filesystem::path& file, Findings& findings);

}  // namespace echoway
