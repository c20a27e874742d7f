#pragma once

#include <array>
#include <span>

#include "echoway/building/building.hpp"

namespace echoway::tracker {

/// Where something answered that is in no plan.
struct Spot {
  RoomIndex room = kNoRoom;
  Vec2 at{};                   ///< In the room's frame.
  double strength = 0.0;       ///< Chance that it answers again, 0 ... 1.
  double last_seen_s = 0.0;
};

/// Remembers unmapped furniture. A cupboard answers again and again; taken for independent accidents, its echoes would
/// outweigh any true place by sheer number. Once remembered it costs nothing more. It never corrects the position,
/// since where it was seen is no surer than where the wearer was.
class EchoMemory {
 public:
  static constexpr std::size_t kMostRecalled = 4;

  /// Spots that may have answered a sensor at `eye` aiming along the unit vector `axis` with an echo from `distance`.
  [[nodiscard]] std::span<const Spot> recall(RoomIndex room, Vec2 eye, Vec2 axis, double distance) noexcept;
  /// Something unmapped answered with probability `chance` from `at`.
  void note(RoomIndex room, Vec2 at, double chance, double time_s) noexcept;
  void clear() noexcept;

 private:
  std::array<Spot, 96> spots_{};
  std::array<Spot, kMostRecalled> recalled_{};
};

}  // namespace echoway::tracker
