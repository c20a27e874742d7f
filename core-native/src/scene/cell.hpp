#pragma once

#include <array>
#include <cstdint>

#include "scene/candidate.hpp"

namespace echoway::scene {

/// What a firing from somewhere in one cell of a room's grid can hit, by the direction fired: the reason why a firing
/// costs the same in a building of ten rooms and of a thousand.
struct Cell {
  static constexpr int kSectors = 32;
  static constexpr int kMaxEntries = 96;
  static constexpr int kMaxItems = 640;
  static constexpr int kMaxOccluders = 384;
  static constexpr std::uint8_t kCoarseOnly = 0x80;       ///< Marks an item that only a coarse beam reaches from this sector.

  struct Entry {
    std::uint16_t reflector = 0;        ///< Index into RoomScene::reflectors.
    std::uint16_t occluder_begin = 0;   ///< Into `occluders`: what might stand in between, from somewhere in the cell.
    std::uint16_t occluder_count = 0;   ///< 0 when nothing can.
  };
  static_assert(kMaxEntries <= kCoarseOnly);

  std::int64_t id = -1;                 ///< Which cell of the building this is.
  bool recently_used = false;
  bool plain_floor = false;             ///< All of the cell is floor of this room: nobody leaves the room here.
  std::uint16_t entry_count = 0;
  std::array<std::uint16_t, kSectors + 1> sector_begin{};
  std::array<Entry, kMaxEntries> entries;
  std::array<std::uint8_t, kMaxItems> items;              ///< Entries by sector; kCoarseOnly may be added.
  std::array<std::uint16_t, kMaxOccluders> occluders;     ///< Indices into RoomScene::occluders.
};

/// Working memory of compile_cell(), reserved once so that filling a cell allocates nothing.
struct CellScratch {
  std::vector<Candidate> seen;
  std::vector<std::uint16_t> between;
};

/// Fills `cell` with what may be seen from the box `low` ... `high` of `room`. A reflector is left out only where no point
/// of the box can see it, so a cell's lists give the same echoes as the whole room would. At most kMaxEntries reflectors,
/// nearest first.
void compile_cell(const RoomScene& room, Vec2 low, Vec2 high, const SightLimits& limits, CellScratch& scratch,
                  Cell& cell);

}  // namespace echoway::scene
