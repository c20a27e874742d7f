#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "echoway/geometry/vec2.hpp"

namespace echoway::fuzz {

/// Takes values off the front of an input; zeros when it has run out.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  [[nodiscard]] bool empty() const noexcept { return rest_.empty(); }

  std::uint8_t byte() noexcept { return take<std::uint8_t>(); }
  std::uint16_t word() noexcept { return take<std::uint16_t>(); }
  std::int32_t integer() noexcept { return take<std::int32_t>(); }

  /// Mostly plain numbers of every size, sometimes any 64 bits at all: NaN, infinity, denormals.
  double number() noexcept {
    const std::uint8_t how = byte();
    if (how < 32) return std::bit_cast<double>(take<std::uint64_t>());
    const double scale[] = {1e-3, 1e-2, 0.1, 1.0, 10.0, 1e3, 1e6, 1e12};
    return static_cast<double>(take<std::int16_t>()) / 256.0 * scale[how % 8];
  }

  /// Within 2.55 m by 2.55 m.
  Vec2 spot() noexcept {
    const double x = 0.01 * byte();
    return {x, 0.01 * byte()};
  }

  std::span<const std::uint8_t> bytes(std::size_t count) noexcept {
    const auto taken = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

 private:
  template <class T>
  T take() noexcept {
    T value{};
    const auto from = bytes(sizeof value);
    if (!from.empty()) std::memcpy(&value, from.data(), from.size());
    return value;
  }

  std::span<const std::uint8_t> rest_;
};

}  // namespace echoway::fuzz
