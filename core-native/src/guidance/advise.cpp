#include "echoway/guidance/advise.hpp"

namespace echoway {

bool advise(Locator& locator, Guide& guide) {
  locator.on_led(guide.has_destination());
  if (const auto transition = guide.take_level_transition()) locator.on_level_transition(*transition);
  const bool doubts = guide.take_doubt();
  if (doubts) locator.on_doubt();
  return doubts;
}

}  // namespace echoway
