#pragma once

#include <optional>
#include <string>
#include <vector>

namespace echoway::import {

/// The numbers of a `level=*` value: `2`, `0;1`, `-1-3` (a range, whole steps), `0.5`. Nothing when it cannot be read
/// or names more levels than a building has.
[[nodiscard]] std::optional<std::vector<double>> parse_osm_levels(const std::string& text);

/// `2`, `-1`, `0.5`
[[nodiscard]] std::string osm_level_name(double number);

}  // namespace echoway::import
