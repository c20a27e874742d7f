#pragma once

#include <cstdint>

#include "echoway/routing/route.hpp"
#include "guidance/view.hpp"

namespace echoway::guidance {

/// A stretch that was told. Who stands well short of its end, or does not even set off when told again, has met something
/// that no sensor saw.
class Stretch {
 public:
  void tell(const View& view, double length_m) noexcept;
  void forget() noexcept { length_m_ = -1.0; }

  enum class Outcome : std::uint8_t {
    open,      ///< None is being walked, or it still is.
    short_of,  ///< The wearer stands well short of its end, but not for long yet.
    met,       ///< Something was met before the chest.
    not_begun  ///< To be told again.
  };
  /// `acted_by`: when the line that told it has been acted upon.
  [[nodiscard]] Outcome watch(const View& view, double acted_by) noexcept;

 private:
  double length_m_ = -1.0;  ///< Negative: none.
  Spot from_{};
  bool begun_ = false;
  int stood_ = 0;           ///< Times in a row, without a step in between, that the wearer did not set off.
};

}  // namespace echoway::guidance
