#pragma once

#include <filesystem>

#include "source/plan.hpp"

/// One reader a format. They sort features by meaning, note what they do not understand, and throw SourceError for what
/// cannot become a building. Coordinates stay degrees.
namespace echoway::import {

[[nodiscard]] Plan read_wrld(const std::filesystem::path& path, Report& report);
[[nodiscard]] Plan read_imdf(const std::filesystem::path& path, Report& report);
[[nodiscard]] Plan read_osm(const std::filesystem::path& path, Report& report);

}  // namespace echoway::import
