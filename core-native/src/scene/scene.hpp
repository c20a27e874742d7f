#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "echoway/belt/belt.hpp"
#include "scene/cell.hpp"
#include "scene/room_scene.hpp"

namespace echoway::scene {

inline constexpr double kCellSize = 0.5;    ///< Metres; more in very large rooms.

/// A building compiled for one belt. Cells are filled when first looked at and kept in a pool of fixed size, so that a
/// large building loads at once, holds little, and the firing path allocates nothing.
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
    const std::int16_t slot = slot_of_cell_[r.first_cell + static_cast<std::size_t>(row) * static_cast<std::size_t>(r.columns) +
                                            static_cast<std::size_t>(column)];
    Cell& cell = slot >= 0 ? slots_[static_cast<std::size_t>(slot)] : compile(r, column, row);
    cell.recently_used = true;
    return cell;
  }

  /// Cells filled so far, those filled again included.
  [[nodiscard]] std::size_t cells_compiled() const noexcept { return cells_compiled_; }

  /// Bytes held.
  [[nodiscard]] std::size_t memory() const noexcept;

 private:
  [[nodiscard]] Cell& compile(const RoomScene& room, int column, int row) noexcept;
  [[nodiscard]] Cell& claim_slot() noexcept;

  std::vector<RoomScene> rooms_;
  SightLimits limits_;
  std::vector<std::int16_t> slot_of_cell_;  ///< -1: not compiled.
  std::vector<Cell> slots_;
  CellScratch scratch_;
  std::size_t cells_compiled_ = 0;
  std::size_t hand_ = 0;                    ///< Of the clock that looks for a slot to use again.
};

}  // namespace echoway::scene
