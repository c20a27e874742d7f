#pragma once

#include <functional>
#include <vector>

#include "scene/room_scene.hpp"

namespace echoway::sim {

/// What can be heard from one room: the room itself and, placed beside it through open doors, its neighbours and theirs.
/// All coordinates are in that room's frame. Sound passes from one room into the next only through a doorway, so rooms
/// whose outlines overlap on the plan do not leak into one another.
class View {
 public:
  struct Portal {
    Segment opening{};
    int leads_to = -1;  ///< Index into rooms(); -1: beyond what is modelled, where sound is lost.
  };
  struct PlacedRoom {
    RoomIndex room = kNoRoom;
    Pose2 frame{};
    RoomScene scene;
    std::vector<Portal> portals;
  };

  /// `scene_of` gives a room's scene in its own frame; `is_open` tells whether a door (index into Building::doors) is.
  View(RoomIndex centre, const std::vector<std::vector<Doorway>>& doorways,
       const std::function<const RoomScene&(RoomIndex)>& scene_of, const std::function<bool(std::size_t)>& is_open);

  [[nodiscard]] const std::vector<PlacedRoom>& rooms() const noexcept { return rooms_; }

  /// Follows the straight line from `from`, in placed room `room`, to `to`. Returns the placed room in which it ends, -1
  /// when something stands in the way. Things within a millimetre of either end do not count.
  [[nodiscard]] int trace(int room, Vec2 from, Vec2 to) const noexcept;

 private:
  void place(RoomIndex room, const Pose2& frame, int from, std::size_t by, int depth,
             const std::vector<std::vector<Doorway>>& doorways,
             const std::function<const RoomScene&(RoomIndex)>& scene_of,
             const std::function<bool(std::size_t)>& is_open);

  std::vector<PlacedRoom> rooms_;
};

}  // namespace echoway::sim
