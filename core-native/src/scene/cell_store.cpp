#include "scene/cell_store.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace echoway::scene {
namespace {

constexpr std::size_t kMaxSlots = 1390;
constexpr std::size_t kBytesPerSlot = 1900;   // What the lists of a cell take in a furnished room.
static_assert(kMaxSlots <= std::numeric_limits<std::int16_t>::max());

std::size_t bytes_of(const Cell& cell) noexcept {
  return cell.entries.size_bytes() + cell.items.size_bytes() + cell.occluders.size_bytes();
}

}  // namespace

CellStore::CellStore(std::size_t cells, std::size_t largest)
    : slot_of_cell_(cells, -1),
      slots_(std::clamp<std::size_t>(cells, 1, kMaxSlots)),
      lists_(std::max(largest, kBytesPerSlot * slots_.size())) {}

const Cell& CellStore::put(std::size_t id, const Cell& cell) noexcept {
  make_room(bytes_of(cell));
  const std::size_t at = (oldest_ + count_) % slots_.size();
  Slot& slot = slots_[at];
  slot.cell = cell;
  slot.id = id;
  slot.begin = end_;
  slot.cell.entries = keep(cell.entries);
  slot.cell.items = keep(cell.items);
  slot.cell.occluders = keep(cell.occluders);
  ++count_;
  slot_of_cell_[id] = static_cast<std::int16_t>(at);
  return slot.cell;
}

// Lists do not go round the end of the memory: what does not fit before it begins anew at its start.
void CellStore::make_room(std::size_t bytes) noexcept {
  const auto begin_of_oldest = [this] { return slots_[oldest_].begin; };
  if (end_ + bytes > lists_.size()) {
    while (count_ > 0 && begin_of_oldest() >= end_) drop_oldest();
    end_ = 0;
  }
  const auto is_in_the_way = [&] { return begin_of_oldest() >= end_ && begin_of_oldest() < end_ + bytes; };
  while (count_ > 0 && (count_ == slots_.size() || is_in_the_way())) drop_oldest();
}

void CellStore::drop_oldest() noexcept {
  slot_of_cell_[slots_[oldest_].id] = -1;
  oldest_ = (oldest_ + 1) % slots_.size();
  --count_;
}

template <typename T>
std::span<const T> CellStore::keep(std::span<const T> list) noexcept {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) == alignof(std::uint16_t) && sizeof(T) % alignof(T) == 0);
  if (list.empty()) return {};
  const T* kept = static_cast<const T*>(std::memcpy(lists_.data() + end_, list.data(), list.size_bytes()));
  end_ += list.size_bytes();
  return {kept, list.size()};
}

std::size_t CellStore::memory() const noexcept {
  return slot_of_cell_.capacity() * sizeof(std::int16_t) + slots_.capacity() * sizeof(Slot) + lists_.capacity();
}

}  // namespace echoway::scene
