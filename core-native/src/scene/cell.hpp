#pragma once

#include <array>
#include <cstdint>

#include "scene/room_scene.hpp"

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

/// How far sensors see, for leaving out what cannot answer.
struct SightLimits {
  double max_range = 0.0;               ///< From the transducer's face, metres.
  double max_edge_range = 0.0;          ///< Beyond it no edge answers.
  double max_mirrored_range = 0.0;      ///< Beyond it nothing is heard by way of a wall.
  double all_reflective_cut_off_rad = 0.0;   ///< All-reflective elements answer within the beam itself, others ...
  double sharp_cut_off_rad = 0.0;       ///< up to this angle off its axis, ...
  double cut_off_rad = 0.0;             ///< up to this one where headings are on a coarse grid ...
  double rough_range = 0.0;             ///< ... but walls nearer than this, which may be rough:
  double rough_cut_off_rad = 0.0;       ///< they are silent beyond this angle.
};

/// A reflector, and the stretch of it from which an echo can come back into a cell.
struct Candidate {
  std::uint16_t reflector = 0;
  double nearest = 0.0;                 ///< Lower bound of its distance from the cell.
  Segment feet{};                       ///< Of a mirrored corner: where the wall may be met.
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
