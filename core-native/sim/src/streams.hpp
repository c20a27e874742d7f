#pragma once

#include <cstdint>

#include "echoway/random.hpp"

namespace echoway::sim {

/// What a piece of chance is for.
enum class Stream : std::uint64_t { room = 1, door_shut, door_leaf, people, firing, lights, air };

/// An independent generator for one thing: what one firing or one room draws never shifts what another does.
[[nodiscard]] constexpr Random stream(std::uint64_t seed, Stream purpose, std::uint64_t index) noexcept {
  Random mix(seed ^ (static_cast<std::uint64_t>(purpose) * 0x9e3779b97f4a7c15ULL));
  return Random(mix.next() ^ Random(index * 0xd1342543de82ef95ULL + 1).next());
}

}  // namespace echoway::sim
