#pragma once

#include <algorithm>
#include <cstdint>

#include "echoway/building/building.hpp"
#include "guidance/view.hpp"

namespace echoway::guidance {

/// A stretch that was told. Who stands well short of its end, or does not even set off when told again, has met
/// something that no sensor saw.
class Stretch {
 public:
  /// REQUIRES: `building` outlives this.
  explicit Stretch(const Building& building) : building_(&building) {}

  void tell(const View& view, double length_m) noexcept;
  void forget() noexcept { length_m_ = -1.0; }
  /// The wearer has been told to stop: who stands sooner than anybody does so has met something all the same.
  void stop(double now) noexcept { stopped_s_ = std::min(stopped_s_, now); }

  enum class Outcome : std::uint8_t {
    open,      ///< None is being walked, or it still is.
    short_of,  ///< The wearer stands well short of its end, but not for long yet.
    met,       ///< Something was met before the chest.
    not_begun  ///< To be told again.
  };
  /// `acted_by`: when the line that told it has been acted upon.
  [[nodiscard]] Outcome watch(const View& view, double acted_by) noexcept;

 private:
  /// A place on a level: it stays the same in a doorway, whichever of its rooms the wearer is taken to be in.
  struct OnLevel {
    int level = 0;
    Vec2 at{};
  };
  [[nodiscard]] OnLevel place_of(const View& view) const noexcept;

  const Building* building_;
  double length_m_ = -1.0;  ///< Negative: none.
  OnLevel from_{};
  bool begun_ = false;
  double stopped_s_ = 1e300; ///< When "Stop." was told first since.
  int stood_ = 0;           ///< Times in a row, without a step in between, that the wearer did not set off.
};

}  // namespace echoway::guidance
