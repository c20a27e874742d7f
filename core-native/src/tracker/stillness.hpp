#pragma once

#include "tracker/echo_pairs.hpp"

namespace echoway::tracker {

/// How many times as likely a pair comes from who has stood meanwhile as from who walks at `pace` m/s. Positive,
/// finite. Who stands still hears the same from all sides a pass later, whatever it was that answered: in a plan, in
/// none, by several reflections. Who walks hears another range from nearly every side. So the belt tells by itself when
/// its wearer stops, as a boot's accelerometer does (zero-velocity updates, Foxlin 2005).
[[nodiscard]] double stillness(const EchoPair& pair, double pace) noexcept;

}  // namespace echoway::tracker
