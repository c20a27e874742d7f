#pragma once

#include <optional>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/random.hpp"

namespace echoway::sim {

/// The floor of one room in square cells, each with its distance to the nearest thing in the plan: where a wearer can
/// stand and how to walk from one place to another without brushing a wall.
class RoomGrid {
 public:
  /// REQUIRES: fits(room).
  explicit RoomGrid(const Room& room);

  /// Whether the room is small enough for so fine a grid: up to half a kilometre square.
  [[nodiscard]] static bool fits(const Room& room) noexcept;

  /// A way from `from` to `to` as a polyline without `from`; empty when there is none.
  [[nodiscard]] std::vector<Vec2> path(Vec2 from, Vec2 to) const;

  /// A random place with room to stand; nothing when the room has none.
  [[nodiscard]] std::optional<Vec2> random_place(Random& random) const;

  /// Metres to the nearest wall or mapped obstacle; negative outside the room.
  [[nodiscard]] double clearance(Vec2 p) const noexcept;

  static constexpr double kCell = 0.125;
  static constexpr double kBody = 0.25;    ///< A wearer's axis stays this far from walls.
  static constexpr double kComfort = 0.5;  ///< And prefers this much.

 private:
  [[nodiscard]] int index(Vec2 p) const noexcept;
  [[nodiscard]] Vec2 centre(int cell) const noexcept;
  [[nodiscard]] bool straight(Vec2 a, Vec2 b, double clearance) const noexcept;

  Vec2 origin_{};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<double> clearance_;
};

}  // namespace echoway::sim
