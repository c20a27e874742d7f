#pragma once

#include <vector>

#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"
#include "echoway/io/logs.hpp"

namespace echoway::tools {

/// The Cramer-Rao floor of a single scan at each of `stands`, metres: the least root-mean-square position error that
/// any unbiased estimator can reach from one pass of the belt in the empty room, heading and echo sources known. Stands
/// where a scan does not fix the position (along a featureless hall) are left out.
[[nodiscard]] std::vector<double> scan_floors(const Building& building, const BeltConfig& belt,
                                              const std::vector<TruthRow>& stands);

}  // namespace echoway::tools
