#pragma once

#include <vector>

#include "tracker/rival.hpp"

namespace echoway::tracker {

/// Beliefs on probation side by side, each against the belief and by itself: what one search found need not have been
/// judged before the next one begins.
class Rivals {
 public:
  /// Room for `most` of them with `capacity` particles each.
  Rivals(std::size_t most, std::size_t capacity) : places_(most, Rival(capacity)) {}

  [[nodiscard]] bool none() const noexcept;
  void dismiss_all() noexcept;
  void dismiss_others(const Rival& kept) noexcept;

  /// Where another one belongs: where there is none, else in place of the one that has gained least since it began.
  [[nodiscard]] Rival& place_for_another() noexcept;

  /// All places; some may be empty.
  [[nodiscard]] auto begin() noexcept { return places_.begin(); }
  [[nodiscard]] auto end() noexcept { return places_.end(); }

 private:
  std::vector<Rival> places_;
};

}  // namespace echoway::tracker
