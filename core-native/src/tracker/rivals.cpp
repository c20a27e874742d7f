#include "tracker/rivals.hpp"

#include <algorithm>

namespace echoway::tracker {

bool Rivals::none() const noexcept { return std::ranges::none_of(places_, &Rival::present); }

void Rivals::dismiss_all() noexcept {
  for (Rival& rival : places_) rival.dismiss();
}

void Rivals::dismiss_others(const Rival& kept) noexcept {
  for (Rival& rival : places_) {
    if (&rival != &kept) rival.dismiss();
  }
}

Rival& Rivals::place_for_another() noexcept {
  const auto empty = std::ranges::find_if_not(places_, &Rival::present);
  return empty != places_.end() ? *empty : *std::ranges::min_element(places_, {}, &Rival::gain);
}

}  // namespace echoway::tracker
