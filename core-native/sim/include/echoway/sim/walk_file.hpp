#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "echoway/result.hpp"
#include "echoway/sim/walk.hpp"

namespace echoway::sim {

/// Reads a walk file (docs/walk-files.md); a `profile` given here takes the place of the one that the file names, whose
/// `world` lines change it all the same. Fails with file:line of the first line that makes no sense.
Result<Walk> read_walk(const std::filesystem::path& file, std::optional<Profile> profile = std::nullopt);

/// The same from text; `file` is only named in errors.
Result<Walk> parse_walk(std::string_view text, const std::string& file);

/// The walk as a file that parse_walk() reads back.
[[nodiscard]] std::string format_walk(const Walk& walk);

}  // namespace echoway::sim
