#include "tracker/fronts.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {

constexpr double kFollow = 0.3;     // Share of the way to what was heard last by which the depth of a front changes.
constexpr double kDepths = 250.0;   // A metre, as it is kept.
constexpr double kSure = 255.0;

std::uint8_t rounded(double value) noexcept { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5); }

}  // namespace

Fronts::Front Fronts::Slot::front() const noexcept { return {depth * (1.0 / kDepths), chance * (1.0 / kSure)}; }

void Fronts::Slot::put(Front front) noexcept {
  depth = rounded(kDepths * front.depth);
  chance = rounded(kSure * front.chance);
}

std::optional<Fronts::Front> Fronts::before(RoomIndex room, std::uint16_t reflector) const noexcept {
  for (const Slot& slot : slots_) {
    if (slot.is_before(room, reflector)) return slot.front();
  }
  return {};
}

void Fronts::note(RoomIndex room, std::uint16_t reflector, Front front) noexcept {
  for (Slot& slot : slots_) {
    if (!slot.is_before(room, reflector)) continue;
    const Front known = slot.front();
    slot.put({known.depth + kFollow * front.chance * (front.depth - known.depth),
              known.chance + front.chance * (1.0 - known.chance)});
    return;
  }
  std::shift_right(slots_.begin(), slots_.end(), 1);
  slots_[0] = {room, reflector};
  slots_[0].put(front);
}

}  // namespace echoway::tracker
