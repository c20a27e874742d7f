#pragma once

#include <string_view>

#include "rooms.hpp"
#include "table.hpp"

namespace echoway::report {

/// Columns of add_readings().
inline constexpr std::string_view kReadingColumns = "figure,sensor,real_m,simulated_m,element";

/// What each sensor of the belt read in `scan` and would read at `pose`; -1 where nothing answers. For the pictures of
/// a match (figures 6.5, 6.7, 6.13, 6.14, 6.23 to 6.26).
void add_readings(std::string_view figure, const thesis::Scan& scan, const RangeModel& model, const Pose2& pose,
                  Table& table);

}  // namespace echoway::report
