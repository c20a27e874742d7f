#pragma once

#include <map>
#include <set>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/result.hpp"
#include "plan/doorway.hpp"
#include "plan/room_grid.hpp"

namespace echoway::sim {

/// How a wearer gets from one room into the next: by a door, or by stairs or an elevator.
struct Passage {
  RoomIndex to = kNoRoom;
  Vec2 leave_at{};   ///< In the room that is left.
  Vec2 arrive_at{};  ///< In the room that is entered.
  int doorway = -1;  ///< Index among the left room's doorways; -1 for a link.
  int link = -1;     ///< Index into Building::links; -1 for a door.
};

/// A stretch of a way that lies in one room, in that room's frame, and what ends it.
struct Stretch {
  RoomIndex room = kNoRoom;
  std::vector<Vec2> points;  ///< Without the place where the stretch begins.
  Passage exit;              ///< exit.to is kNoRoom at the end of the way.
};

/// Whether every room is small enough to walk in; fails with the first that is not.
[[nodiscard]] Status check_floors(const Building& building);

/// What a wearer knows of a building: doorways, and how to get from one place to another.
class FloorPlan {
 public:
  /// REQUIRES: check_floors(building).
  explicit FloorPlan(const Building& building);

  [[nodiscard]] const Building& building() const noexcept { return building_; }
  [[nodiscard]] const std::vector<Doorway>& doorways(RoomIndex room) const;
  [[nodiscard]] const std::vector<std::vector<Doorway>>& doorways() const noexcept { return doorways_; }
  [[nodiscard]] const std::vector<Passage>& passages(RoomIndex room) const;
  [[nodiscard]] const RoomGrid& grid(RoomIndex room) const;

  /// The way from one place to another by doors that are not in `shut` (indices into Building::doors), stairs and
  /// elevators.
  [[nodiscard]] Result<std::vector<Stretch>> route(RoomIndex from_room, Vec2 from, RoomIndex to_room, Vec2 to,
                                                   const std::set<std::size_t>& shut = {}) const;

 private:
  [[nodiscard]] std::vector<Passage> chain(RoomIndex from_room, Vec2 from, RoomIndex to_room,
                                           const std::set<std::size_t>& shut) const;

  const Building& building_;
  std::vector<std::vector<Doorway>> doorways_;
  std::vector<std::vector<Passage>> passages_;
  mutable std::map<RoomIndex, RoomGrid> grids_;
};

}  // namespace echoway::sim
