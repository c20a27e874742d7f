#pragma once

#include <optional>
#include <vector>

#include "scene/room_scene.hpp"

namespace echoway::sim {

/// What a View is put together from.
class Surroundings {
 public:
  Surroundings() = default;
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;
  virtual ~Surroundings() = default;

  [[nodiscard]] virtual const std::vector<Doorway>& doorways(RoomIndex room) const = 0;
  /// In the room's own frame.
  [[nodiscard]] virtual const RoomScene& scene(RoomIndex room) = 0;
  /// `door`: index into Building::doors.
  [[nodiscard]] virtual bool is_open(std::size_t door) const = 0;
  /// The leaf of an open door where it stands in `room`, if it does.
  [[nodiscard]] virtual std::optional<Segment> leaf(RoomIndex room, const Doorway& doorway) = 0;
};

/// What can be heard from one room: the room itself and, placed beside it through open doors, its neighbours and
/// theirs. All coordinates are in that room's frame. Sound passes from one room into the next only through a doorway,
/// so rooms whose outlines overlap on the plan do not leak into one another.
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

  View(RoomIndex centre, Surroundings& surroundings);

  [[nodiscard]] const std::vector<PlacedRoom>& rooms() const noexcept { return rooms_; }

  /// The first panel that a ray from `from`, in placed room `room`, meets within `reach` metres, and the placed room it
  /// stands in; nullptr when it meets none.
  struct Hit {
    const Panel* panel = nullptr;
    int room = -1;
  };
  [[nodiscard]] Hit first_panel(int room, Vec2 from, Vec2 direction, double reach) const noexcept;

  /// Follows the straight line from `from`, in placed room `room`, to `to`. Returns the placed room in which it ends,
  /// -1 when something stands in the way. Things within a millimetre of either end do not count.
  [[nodiscard]] int trace(int room, Vec2 from, Vec2 to) const noexcept;

 private:
  struct Entrance {
    int from = -1;            // Placed room from which this one is entered; -1 for the centre.
    std::size_t doorway = 0;  // Of the entered room.
  };
  void place(RoomIndex room, const Pose2& frame, const Entrance& entrance, int depth, Surroundings& surroundings);

  std::vector<PlacedRoom> rooms_;
};

}  // namespace echoway::sim
