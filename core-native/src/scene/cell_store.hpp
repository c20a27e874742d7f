#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/cell.hpp"

namespace echoway::scene {

/// The cells compiled last, in memory of fixed size: a full room's cells take much of it, others little. The oldest
/// make room for a new one, so nothing is allocated after construction and no cell is ever too large.
class CellStore {
 public:
  /// For a building of so many cells, none of which takes more than `largest` bytes.
  CellStore(std::size_t cells, std::size_t largest);

  /// Null when it is not there. What is found holds until the next put().
  [[nodiscard]] const Cell* find(std::size_t id) const noexcept {
    const std::int16_t slot = slot_of_cell_[id];
    return slot >= 0 ? &slots_[static_cast<std::size_t>(slot)].cell : nullptr;
  }

  /// Keeps a copy of `cell` and its lists. REQUIRES: cell `id` is not there.
  const Cell& put(std::size_t id, const Cell& cell) noexcept;

  /// Bytes held.
  [[nodiscard]] std::size_t memory() const noexcept;

 private:
  struct Slot {
    Cell cell;
    std::size_t id = 0;
    std::size_t begin = 0;    ///< Of its lists in lists_.
  };

  void make_room(std::size_t bytes) noexcept;
  void drop_oldest() noexcept;
  template <typename T>
  [[nodiscard]] std::span<const T> keep(std::span<const T> list) noexcept;

  std::vector<std::int16_t> slot_of_cell_;   ///< -1: not there.
  std::vector<Slot> slots_;                  ///< A ring, as are the lists; both in the order of put().
  std::vector<std::byte> lists_;
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t end_ = 0;                      ///< Of the newest lists.
};

}  // namespace echoway::scene
