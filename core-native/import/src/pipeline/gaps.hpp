#pragma once

#include <string>
#include <vector>

#include "echoway/import/report.hpp"
#include "geometry/geos.hpp"

namespace echoway::import {

struct BarrierPart {
  geos::Shape shape;
  Source source;
};

/// `barrier` with its gaps closed: all of up to 5 cm, and those of up to 40 cm (nobody fits through) that would let two
/// rooms run together or a room run out of `inside`. Every gap that parts two spaces is reported with the features at
/// its ends.
[[nodiscard]] geos::Shape close_gaps(const geos::Shape& barrier, const std::vector<BarrierPart>& parts,
                                     const geos::Shape& inside, const std::string& level, Report* report);

}  // namespace echoway::import
