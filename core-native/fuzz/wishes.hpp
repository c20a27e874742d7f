#pragma once

#include <array>
#include <string>
#include <variant>

#include "echoway/result.hpp"
#include "echoway/routing/router.hpp"
#include "reader.hpp"

namespace echoway::fuzz {

/// A clock that mostly walks on, and now and then stands, jumps or breaks.
class Clock {
 public:
  double next(Reader& in) {
    const std::uint8_t how = in.byte();
    if (how >= 16) return now_ += 0.001 * how;
    if (how >= 12) return now_ -= in.number();
    if (how >= 4) return now_;
    return how == 0 ? in.number() : std::array{0.0, 1e300, 1e18, -1e300}[how];
  }

 private:
  double now_ = 0.0;
};

inline Goal any_goal(Reader& in) {
  Goal goal;
  goal.kind = static_cast<Goal::Kind>(in.byte() % 5);
  goal.index = static_cast<std::int32_t>(in.byte() % 8) - 2;
  goal.spot = {static_cast<RoomIndex>(in.byte() % 8) - 2, {in.number(), in.number()}};
  return goal;
}

inline std::string any_name(Reader& in) {
  const auto bytes = in.bytes(in.byte() % 16);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What the wearer wants of a Session or a Guide. Each may be refused, with words.
template <class Asked>
Status ask(Asked& asked, Reader& in) {
  const std::uint8_t what = in.byte();
  const RoutePreferences preferences{.avoid_stairs = (what & 128) != 0};
  switch (what % 8) {
    case 0: return asked.set_destination(any_name(in), preferences);
    case 1: return asked.set_destination("way out", preferences);
    case 2: return asked.set_destination(any_goal(in), preferences);
    case 3: return asked.way_out(preferences);
    case 4: return asked.back_track();
    case 5: asked.clear_destination(); break;
    case 6: asked.where_am_i(); break;
    default: static_cast<void>(asked.repeat());
  }
  return success();
}

}  // namespace echoway::fuzz
