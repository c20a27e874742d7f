#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "echoway/geometry/vec2.hpp"

namespace echoway::tracker {

/// What answered the last firings and is in no plan, as one particle sees it: how likely that was so, and where it
/// stands by the way that the particle has gone since. A map of each particle's own (FastSLAM: Montemerlo et al. 2002);
/// a particle that missed a turn has it in the wrong place. When a note is too old is EchoRepeats' to say. Corrections
/// of the particle's position by echoes are no way gone: what a place was wrong by it was wrong by before.
class Strangers {
 public:
  /// Sensors share a slot when a belt has more of them; the newest echo counts.
  static constexpr std::size_t kSlots = 16;

  /// The particle went so far, metres in its room's frame.
  void move(Vec2 by) noexcept {
    way_ = way_ + by;
    if (!(squared_norm(way_) < kFarOn * kFarOn)) turn({1.0, 0.0});   // Which begins the way anew.
  }
  /// The room's frame is another one now, `rotation` the cosine and sine by which directions change.
  void turn(Vec2 rotation) noexcept;
  /// None is known.
  void forget() noexcept { chance_.fill(0); }

  /// Something answered `from_here`, metres in the room's frame; 0 ... 1: the chance that it is in no plan.
  void note(std::size_t slot, Vec2 from_here, double chance) noexcept;
  /// That chance, to 1/255; 0 if nothing is known.
  [[nodiscard]] double chance(std::size_t slot) const noexcept { return chance_[slot] * (1.0 / kSure); }
  /// Where that is now, metres from the particle in the room's frame; to a millimetre.
  [[nodiscard]] Vec2 from_here(std::size_t slot) const noexcept {
    return Vec2{x_[slot] * kMillimetre, y_[slot] * kMillimetre} - way_;
  }

 private:
  static constexpr double kSure = 255.0;
  static constexpr double kMillimetre = 1e-3;
  static constexpr double kFarOn = 15.0;    ///< Metres: numbers so short reach to 32, and sensors about 11.

  void put(std::size_t slot, Vec2 from_here) noexcept;

  Vec2 way_{};                                   ///< Gone since it began anew, and where they stand from there,
  std::array<std::int16_t, kSlots> x_{}, y_{};   ///< millimetres: there are thousands of particles.
  std::array<std::uint8_t, kSlots> chance_{};
};

}  // namespace echoway::tracker
