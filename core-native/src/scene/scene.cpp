#include "scene/scene.hpp"

#include <algorithm>
#include <limits>

#include "scene/audible.hpp"

namespace echoway::scene {
namespace {

constexpr std::size_t kMaxSlots = 2400;   // Five megabytes.
static_assert(kMaxSlots <= std::numeric_limits<std::int16_t>::max());

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

}  // namespace

Scene::Scene(const Building& building, const SightLimits& limits) : rooms_(compile_audible(building, limits)), limits_(limits) {
  std::size_t cells = 0;
  for (const RoomScene& r : rooms_) cells += static_cast<std::size_t>(r.columns) * static_cast<std::size_t>(r.rows);
  std::size_t reflectors = 0;
  std::size_t occluders = 0;
  for (const RoomScene& r : rooms_) {
    reflectors = std::max(reflectors, r.reflectors.size());
    occluders = std::max(occluders, r.occluders.size());
  }
  scratch_.seen.reserve(reflectors);
  scratch_.between.reserve(occluders);
  slot_of_cell_.assign(cells, -1);
  slots_.resize(std::clamp<std::size_t>(cells, 1, kMaxSlots));
}

Cell& Scene::claim_slot() noexcept {
  for (;;) {
    Cell& slot = slots_[hand_];
    hand_ = hand_ + 1 == slots_.size() ? 0 : hand_ + 1;
    if (slot.id >= 0 && slot.recently_used) {
      slot.recently_used = false;
      continue;
    }
    if (slot.id >= 0) slot_of_cell_[static_cast<std::size_t>(slot.id)] = -1;
    return slot;
  }
}

Cell& Scene::compile(const RoomScene& room, int column, int row) noexcept {
  const std::size_t id = room.first_cell + static_cast<std::size_t>(row) * static_cast<std::size_t>(room.columns) +
                         static_cast<std::size_t>(column);
  Cell& cell = claim_slot();
  const double size = room.cell_size;
  const Vec2 low = room.grid_origin + Vec2{column * size, row * size};
  compile_cell(room, low, low + Vec2{size, size}, limits_, scratch_, cell);
  ++cells_compiled_;
  cell.id = static_cast<std::int64_t>(id);
  slot_of_cell_[id] = static_cast<std::int16_t>(&cell - slots_.data());
  return cell;
}

std::size_t Scene::memory() const noexcept {
  std::size_t bytes = slot_of_cell_.capacity() * sizeof(std::int16_t) + slots_.capacity() * sizeof(Cell);
  for (const RoomScene& r : rooms_) {
    bytes += sizeof(RoomScene) + r.reflectors.capacity() * sizeof(Reflector) + r.occluders.capacity() * sizeof(Segment) +
             r.openings.capacity() * sizeof(Opening) + r.floor.vertices.capacity() * sizeof(Vec2) +
             r.floor.begin.capacity() * sizeof(std::uint32_t);
  }
  return bytes;
}

}  // namespace echoway::scene
