#pragma once

#include <filesystem>

#include "echoway/building/building.hpp"
#include "echoway/result.hpp"

namespace echoway {

/// Writes `building` as a folder that load_building() reads back to the same building (coordinates to 0.1 mm in the
/// building's own unit). `dir` is made when missing; files appear whole or not at all.
Status write_building(const Building& building, const std::filesystem::path& dir);

}  // namespace echoway
