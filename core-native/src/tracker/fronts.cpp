#include "tracker/fronts.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {

constexpr double kFollow = 0.3;     // Share of the way to what was heard last by which the depth of a front changes.
constexpr double kDepths = 250.0;   // A metre, as it is kept.
constexpr double kSure = 255.0;

std::uint8_t rounded(double value) noexcept { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5); }

}  // namespace

std::size_t Fronts::find(RoomIndex room, std::uint16_t reflector) const noexcept {
  std::size_t slot = 0;
  while (slot < kSlots && !(reflector_[slot] == reflector && room_[slot] == room)) ++slot;
  return slot;
}

Fronts::Front Fronts::at(std::size_t slot) const noexcept {
  return {depth_[slot] * (1.0 / kDepths), chance_[slot] * (1.0 / kSure)};
}

void Fronts::put(std::size_t slot, Front front) noexcept {
  depth_[slot] = rounded(kDepths * front.depth);
  chance_[slot] = rounded(kSure * front.chance);
}

std::optional<Fronts::Front> Fronts::before(RoomIndex room, std::uint16_t reflector) const noexcept {
  const std::size_t slot = find(room, reflector);
  if (slot == kSlots) return {};
  return at(slot);
}

void Fronts::note(RoomIndex room, std::uint16_t reflector, Front front) noexcept {
  const std::size_t slot = find(room, reflector);
  if (slot < kSlots) {
    const Front known = at(slot);
    put(slot, {known.depth + kFollow * front.chance * (front.depth - known.depth),
               known.chance + front.chance * (1.0 - known.chance)});
    return;
  }
  const auto make_room = [](auto& slots) { std::shift_right(slots.begin(), slots.end(), 1); };
  make_room(room_);
  make_room(reflector_);
  make_room(depth_);
  make_room(chance_);
  room_[0] = room;
  reflector_[0] = reflector;
  put(0, front);
}

}  // namespace echoway::tracker
