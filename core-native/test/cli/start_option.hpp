#pragma once

#include <string>

#include "echoway/io/logs.hpp"
#include "echoway/units.hpp"

namespace echoway::test {

/// A row of the truth as `--start` takes it.
inline std::string start_option(const TruthRow& row) {
  return row.room + "," + std::to_string(row.pose.position.x) + "," + std::to_string(row.pose.position.y) + "," +
         std::to_string(to_degrees(row.pose.heading));
}

}  // namespace echoway::test
