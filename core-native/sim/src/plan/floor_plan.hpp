#pragma once

#include <map>
#include <memory>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/result.hpp"
#include "plan/doorway.hpp"
#include "plan/room_grid.hpp"

namespace echoway::sim {

/// A stretch of a way that lies in one room, in that room's frame.
struct Stretch {
  RoomIndex room = kNoRoom;
  std::vector<Vec2> points;  ///< Without the place where the stretch begins.
};

/// What a wearer knows of a building: doorways, and how to get from one place to another.
class FloorPlan {
 public:
  explicit FloorPlan(const Building& building);

  [[nodiscard]] const Building& building() const noexcept { return building_; }
  [[nodiscard]] const std::vector<Doorway>& doorways(RoomIndex room) const;
  [[nodiscard]] const RoomGrid& grid(RoomIndex room) const;

  /// The way from one place to another through doors. Each stretch but the last ends in the middle of a doorway.
  [[nodiscard]] Result<std::vector<Stretch>> route(RoomIndex from_room, Vec2 from, RoomIndex to_room, Vec2 to) const;

 private:
  [[nodiscard]] std::vector<std::size_t> door_chain(RoomIndex from_room, Vec2 from, RoomIndex to_room) const;

  const Building& building_;
  std::vector<std::vector<Doorway>> doorways_;
  mutable std::map<RoomIndex, RoomGrid> grids_;
};

}  // namespace echoway::sim
