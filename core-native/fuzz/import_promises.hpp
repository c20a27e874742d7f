#pragma once

#include <filesystem>
#include <string>

#include "echoway/import/import.hpp"

namespace echoway::fuzz {

/// Imports a plan, writes the building and reads it back. Empty when the plan was refused with words that name a file,
/// or became a building that holds and loads; else what did not.
[[nodiscard]] std::string check_import(import::SourceFormat format, const std::filesystem::path& plan);

}  // namespace echoway::fuzz
