#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "echoway/building/building.hpp"

namespace echoway::tracker {

/// What stands with its back to the plan's walls, as one particle sees it: how far before which wall. Most of what is
/// in no plan stands so, and answers for as long as the wearer is about. Were each echo a new surprise, a row of
/// cupboards would drive out the right place for one that takes their faces for the wall. A map of each particle's own
/// (FastSLAM: Montemerlo et al. 2002): who stands elsewhere has it elsewhere. It outlasts Strangers: walls do not move.
class Fronts {
 public:
  static constexpr std::size_t kSlots = 6;   ///< Walls kept in mind; the one noted first makes room for another.

  struct Front {
    double depth;     ///< Metres before the wall, 0 ... 1; kept to 2 mm.
    double chance;    ///< That something stands there, 0 ... 1; kept to 1/255.
  };
  /// Before the wall that is `reflector` of `room` (RoomScene::reflectors); nothing when none is known.
  [[nodiscard]] std::optional<Front> before(RoomIndex room, std::uint16_t reflector) const noexcept;

  /// Something answered from there: `front.chance` is the chance that it did.
  void note(RoomIndex room, std::uint16_t reflector, Front front) noexcept;
  /// None is known.
  void forget() noexcept { *this = {}; }

 private:
  /// There are thousands of particles, hence short numbers.
  struct Slot {
    RoomIndex room = kNoRoom;
    std::uint16_t reflector = 0;
    std::uint8_t depth = 0, chance = 0;

    [[nodiscard]] bool is_before(RoomIndex of, std::uint16_t wall) const noexcept {
      return reflector == wall && room == of;
    }
    [[nodiscard]] Front front() const noexcept;
    void put(Front front) noexcept;
  };
  std::array<Slot, kSlots> slots_{};   ///< The newest first.
};

}  // namespace echoway::tracker
