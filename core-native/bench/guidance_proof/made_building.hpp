#pragma once

#include <string>

#include "echoway/building/building.hpp"
#include "echoway/result.hpp"

namespace echoway::proof {

/// The building that `map` names: office, grid or levels made here, else a building's folder.
[[nodiscard]] Result<Building> building_of(const std::string& map);

}  // namespace echoway::proof
