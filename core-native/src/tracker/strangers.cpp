#include "tracker/strangers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoway::tracker {
namespace {

std::int16_t in_millimetres(double metres) noexcept {
  constexpr double kMost = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::clamp(std::floor(1000.0 * metres + 0.5), -kMost, kMost));
}

}  // namespace

void Strangers::turn(Vec2 rotation) noexcept {
  std::array<Vec2, kSlots> here;
  for (std::size_t i = 0; i < kSlots; ++i) here[i] = from_here(i);
  way_ = {};
  for (std::size_t i = 0; i < kSlots; ++i) put(i, rotated(here[i], rotation));
}

void Strangers::note(std::size_t slot, Vec2 from_here, double chance) noexcept {
  put(slot, from_here);
  chance_[slot] = static_cast<std::uint8_t>(kSure * std::clamp(chance, 0.0, 1.0));
}

void Strangers::put(std::size_t slot, Vec2 from_here) noexcept {
  x_[slot] = in_millimetres(way_.x + from_here.x);
  y_[slot] = in_millimetres(way_.y + from_here.y);
}

}  // namespace echoway::tracker
