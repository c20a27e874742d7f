#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/candidate.hpp"
#include "scene/visibility.hpp"

namespace echoway::scene {

/// What a firing from somewhere in one cell of a room's grid can hit, by the direction fired: the reason why a firing
/// costs the same in a building of ten rooms and of a thousand. Whoever made the cell holds its lists.
struct Cell {
  static constexpr int kSectors = 32;
  /// Marks an item that only a coarse beam reaches from this sector.
  static constexpr std::uint16_t kCoarseOnly = 0x8000;

  struct Entry {
    std::uint16_t reflector = 0;        ///< Index into RoomScene::reflectors.
    std::uint16_t occluder_begin = 0;   ///< Into `occluders`: what might stand in between, from somewhere in the cell.
    std::uint16_t occluder_count = 0;   ///< 0 when nothing can.
  };

  bool plain_floor = false;             ///< All of the cell is floor of this room: nobody leaves the room here.
  std::array<std::uint32_t, kSectors + 1> sector_begin{};
  std::span<const Entry> entries;
  std::span<const std::uint16_t> items;       ///< Entries by sector; kCoarseOnly may be added.
  std::span<const std::uint16_t> occluders;   ///< Indices into RoomScene::occluders.
};

/// Working memory of compile_cell(), reserved once so that compiling a cell allocates nothing.
class CellScratch {
 public:
  /// For rooms of at most so many reflectors and occluders.
  CellScratch(std::size_t reflectors, std::size_t occluders);

  /// Bytes that the lists of one cell can take at most.
  [[nodiscard]] std::size_t largest_cell() const noexcept;
  [[nodiscard]] std::size_t memory() const noexcept;

 private:
  friend class CellCompiler;

  // Sectors from which the beam reaches an entry, and from which it does where headings are on a coarse grid.
  struct Reach {
    std::uint32_t sharp = 0;
    std::uint32_t coarse = 0;
  };

  std::vector<Bounds> bounds_;           ///< Of the room's occluders, some at a time.
  std::vector<Reach> reaches_;
  std::vector<std::uint16_t> between_;
  std::vector<Cell::Entry> entries_;
  std::vector<std::uint16_t> items_;
  std::vector<std::uint16_t> occluders_;
};

/// What may be seen from the box `low` ... `high` of `room`, in the room's order. A reflector or an occluder is left
/// out only where no point of the box can tell, so a cell's lists give the same echoes as the whole room would. The
/// lists stand in `scratch` until the next call. REQUIRES: `scratch` was made for rooms as large as `room`.
[[nodiscard]] Cell compile_cell(const RoomScene& room, Vec2 low, Vec2 high, const SightLimits& limits,
                                CellScratch& scratch) noexcept;

}  // namespace echoway::scene
