#pragma once

#include <string>

#include "echoway/building/building.hpp"

namespace echoway::fuzz {

/// What everybody may rely on who gets a building, wherever it came from: all is finite, floors are loops that run the
/// right way round, doors, links and places name rooms that there are. Empty when it holds, else what does not.
[[nodiscard]] std::string check_building_promises(const Building& building);

}  // namespace echoway::fuzz
