#include "scene/scene.hpp"

#include <algorithm>

#include "scene/audible.hpp"

namespace echoway::scene {
namespace {

constexpr std::size_t kEmptyCell = 8;   // Occluders that take as long to list as a cell of which nothing is heard.

std::vector<RoomScene> compile_audible(const Building& building, const SightLimits& limits) {
  const RoomCompiler compiler(building, limits.max_range, kCellSize);
  std::vector<RoomScene> rooms;
  rooms.reserve(compiler.rooms());
  for (std::size_t i = 0; i < compiler.rooms(); ++i) {
    rooms.push_back(compiler.compile(static_cast<RoomIndex>(i)));
    leave_out_inaudible(rooms.back(), limits);
  }
  return rooms;
}

CellScratch scratch_for(const std::vector<RoomScene>& rooms) {
  std::size_t reflectors = 0;
  std::size_t occluders = 0;
  for (const RoomScene& r : rooms) {
    reflectors = std::max(reflectors, r.reflectors.size());
    occluders = std::max(occluders, r.occluders.size());
  }
  return {reflectors, occluders};
}

std::size_t count_cells(const std::vector<RoomScene>& rooms) noexcept {
  std::size_t cells = 0;
  for (const RoomScene& r : rooms) cells += static_cast<std::size_t>(r.columns) * static_cast<std::size_t>(r.rows);
  return cells;
}

}  // namespace

Scene::Scene(const Building& building, const SightLimits& limits)
    : rooms_(compile_audible(building, limits)),
      limits_(limits),
      scratch_(scratch_for(rooms_)),
      cells_(count_cells(rooms_), scratch_.largest_cell()) {}

Cell Scene::compile(const RoomScene& room, Vec2 low, Vec2 high) noexcept {
  const Cell cell = compile_cell(room, low, high, limits_, scratch_);
  compile_work_ += kEmptyCell + cell.occluders.size();
  return cell;
}

const Cell& Scene::compile_and_keep(const RoomScene& room, int column, int row) noexcept {
  const std::size_t id = room.first_cell + static_cast<std::size_t>(row) * static_cast<std::size_t>(room.columns) +
                         static_cast<std::size_t>(column);
  const double size = room.cell_size;
  const Vec2 low = room.grid_origin + Vec2{column * size, row * size};
  return cells_.put(id, compile(room, low, low + Vec2{size, size}));
}

std::size_t Scene::memory() const noexcept {
  std::size_t bytes = scratch_.memory() + cells_.memory();
  for (const RoomScene& r : rooms_) {
    bytes += sizeof(RoomScene) + r.reflectors.capacity() * sizeof(Reflector) +
             r.occluders.capacity() * sizeof(Segment) + r.openings.capacity() * sizeof(Opening) +
             r.floor.vertices.capacity() * sizeof(Vec2) + r.floor.begin.capacity() * sizeof(std::uint32_t);
  }
  return bytes;
}

}  // namespace echoway::scene
