#pragma once

#include <string>

#include "echoway/building/building.hpp"
#include "echoway/scene/scene_report.hpp"

namespace echoway::tools {

/// What `report` says of `building`, for people: a line a room and a summary.
[[nodiscard]] std::string left_out_table(const SceneReport& report, const Building& building);

}  // namespace echoway::tools
