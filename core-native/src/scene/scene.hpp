#pragma once

#include <algorithm>
#include <vector>

#include "echoway/belt/belt.hpp"
#include "scene/cell_store.hpp"
#include "scene/room_scene.hpp"

namespace echoway::scene {

inline constexpr double kCellSize = 0.5;    ///< Metres; more in very large rooms.

/// A building compiled for one belt. Cells are compiled when first looked at and kept in memory of fixed size, so that
/// a large building loads at once, holds little, and the firing path allocates nothing.
class Scene {
 public:
  Scene(const Building& building, const SightLimits& limits);

  [[nodiscard]] const RoomScene& room(RoomIndex r) const noexcept { return rooms_[static_cast<std::size_t>(r)]; }
  [[nodiscard]] std::size_t room_count() const noexcept { return rooms_.size(); }
  [[nodiscard]] const SightLimits& limits() const noexcept { return limits_; }

  /// The cell of `room` in which `p` lies (or the nearest one). The reference holds until the next call.
  [[nodiscard]] const Cell& cell_at(RoomIndex room, Vec2 p) noexcept {
    const RoomScene& r = rooms_[static_cast<std::size_t>(room)];
    const Vec2 local = r.cells_per_metre * (p - r.grid_origin);
    const int column = static_cast<int>(std::clamp(local.x, 0.0, r.columns - 0.5));
    const int row = static_cast<int>(std::clamp(local.y, 0.0, r.rows - 0.5));
    const Cell* const cell =
        cells_.find(r.first_cell + static_cast<std::size_t>(row) * static_cast<std::size_t>(r.columns) +
                    static_cast<std::size_t>(column));
    return cell != nullptr ? *cell : compile_and_keep(r, column, row);
  }

  /// What can be seen from the box `low` ... `high` of `room`, of any size: for who looks round in many places close
  /// together and does not come back. Nothing is kept: its lists hold until the next call, or one of cell_at().
  [[nodiscard]] Cell seen_from(RoomIndex room, Vec2 low, Vec2 high) noexcept {
    return compile(rooms_[static_cast<std::size_t>(room)], low, high);
  }

  /// What compiling cells has taken so far, those compiled again included: about so many occluders were listed.
  [[nodiscard]] std::size_t compile_work() const noexcept { return compile_work_; }

  /// Bytes held.
  [[nodiscard]] std::size_t memory() const noexcept;

 private:
  [[nodiscard]] Cell compile(const RoomScene& room, Vec2 low, Vec2 high) noexcept;
  [[nodiscard]] const Cell& compile_and_keep(const RoomScene& room, int column, int row) noexcept;

  std::vector<RoomScene> rooms_;
  SightLimits limits_;
  CellScratch scratch_;
  CellStore cells_;
  std::size_t compile_work_ = 0;
};

}  // namespace echoway::scene
