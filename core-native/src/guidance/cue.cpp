#include "echoway/guidance/cue.hpp"

#include <array>
#include <cmath>

#include "echoway/geometry/pose2.hpp"

namespace echoway {
namespace {

struct KindTraits {
  const char* name;
  Urgency urgency;
};

// In the order of CueKind.
constexpr std::array<KindTraits, kCueKinds> kTraits = {{
    {"stop", Urgency::danger},
    {"obstacle", Urgency::danger},
    {"uncertain", Urgency::broken},
    {"probe_turn", Urgency::broken},
    {"probe_step", Urgency::broken},
    {"found", Urgency::broken},
    {"belt_lost", Urgency::broken},
    {"belt_back", Urgency::broken},
    {"battery_low", Urgency::broken},
    {"sensor_blocked", Urgency::broken},
    {"wrong_way", Urgency::turn},
    {"rerouted", Urgency::turn},
    {"no_way", Urgency::turn},
    {"turn", Urgency::turn},
    {"bear", Urgency::turn},
    {"go_straight", Urgency::turn},
    {"arrived", Urgency::turn},
    {"take_link", Urgency::turn},
    {"room_here", Urgency::asked},
    {"facing", Urgency::asked},
    {"destination", Urgency::asked},
    {"door", Urgency::place},
    {"stairs", Urgency::place},
    {"elevator", Urgency::place},
    {"exit", Urgency::place},
    {"place", Urgency::place},
    {"narrow", Urgency::place},
    {"entering", Urgency::place},
}};

}  // namespace

const char* to_string(CueKind kind) noexcept { return kTraits[static_cast<std::size_t>(kind)].name; }
Urgency urgency_of(CueKind kind) noexcept { return kTraits[static_cast<std::size_t>(kind)].urgency; }

Cue make_cue(CueKind kind) noexcept {
  Cue cue;
  cue.kind = kind;
  cue.urgency = urgency_of(kind);
  return cue;
}

Sector sector_of(double direction) noexcept {
  const double angle = wrap_angle(direction);
  const double size = std::abs(angle);
  const bool left = angle > 0.0;
  // A hair of slack, so that a rounded 20 degrees still is "within 20 degrees".
  constexpr double kHair = 1e-9;
  if (size <= degrees(20.0) + kHair) return Sector::ahead;
  if (size <= degrees(45.0) + kHair) return left ? Sector::slightly_left : Sector::slightly_right;
  if (size <= degrees(120.0) + kHair) return left ? Sector::left : Sector::right;
  if (size <= degrees(160.0) + kHair) return left ? Sector::sharp_left : Sector::sharp_right;
  return Sector::behind;
}

}  // namespace echoway
