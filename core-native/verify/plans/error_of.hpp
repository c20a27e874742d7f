#pragma once

#include <limits>

#include "echoway/building/building.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/locate/estimate.hpp"

namespace echoway::plans {

/// Metres between where an estimate says that the wearer is and where they are, in the level's frame; infinity while
/// either is in no room of the building.
[[nodiscard]] inline double error_of(const Estimate& estimate, const TruthRow& truth, const Building& building) {
  const RoomIndex room = building.find_room(truth.room);
  if (estimate.room == kNoRoom || room == kNoRoom) return std::numeric_limits<double>::infinity();
  const Vec2 told = building.room(estimate.room).frame.transform(estimate.pose.position);
  return distance(told, building.room(room).frame.transform(truth.pose.position));
}

}  // namespace echoway::plans
