#pragma once

#include <cstdint>

#include "echoway/building/building.hpp"

namespace echoway {

/// What a wearer is told. Structured, no prose: echoway/speech puts it into words.
enum class CueKind : std::uint8_t {
  stop,            ///< Stand still: the next step may meet a wall.
  obstacle,        ///< Something that no plan knows is near, in `direction`.
  uncertain,       ///< Not sure where the wearer is: stop and turn slowly.
  probe_turn,      ///< Turn slowly towards `direction`: it will tell the possible places apart.
  probe_step,      ///< One step towards `direction` will.
  found,           ///< Sure again; `room`.
  belt_lost,
  belt_back,
  battery_low,
  sensor_blocked,  ///< `direction` says which sensor.
  wrong_way,
  rerouted,        ///< Another way than before.
  no_way,          ///< No safe way leads to the destination.
  turn,            ///< Turn on the spot to `direction`.
  bear,            ///< Keep walking, a little more to `direction`'s side.
  go_straight,     ///< For `distance_m`.
  arrived,         ///< At `landmark`, which lies in `direction`.
  take_link,       ///< Climb, descend or ride now; `landmark` is the link.
  room_here,       ///< `room`, because the wearer asked.
  facing,          ///< The wearer looks at `landmark`, or at a wall when it is none.
  destination,     ///< A way to `landmark` is set, `distance_m` long.
  door,            ///< A door in `direction`.
  stairs,          ///< Stairs in `direction`.
  elevator,
  exit,
  place,           ///< `landmark` in `direction`.
  narrow,          ///< The way ahead is narrower than usual.
  entering,        ///< Walked into `room`.
};
inline constexpr int kCueKinds = static_cast<int>(CueKind::entering) + 1;

/// The name by which cues are logged.
[[nodiscard]] const char* to_string(CueKind kind) noexcept;

/// Which line goes first, and which may cut off which: a line is cut off only by one of a lower number.
enum class Urgency : std::uint8_t {
  danger,
  broken,  ///< Lost, or something does not work.
  turn,
  asked,
  place,
  colour,
};

/// The thing that a cue speaks of.
struct CueLandmark {
  enum class Kind : std::uint8_t { none, door, link, place, exit, room } kind = Kind::none;
  std::int32_t index = -1;  ///< Into the Building's doors, links, places, exits or rooms.

  friend constexpr bool operator==(const CueLandmark&, const CueLandmark&) = default;
};

/// A second fact in the same breath ("New route. Turn right.").
struct CueTail {
  CueKind kind = CueKind::stop;
  bool present = false;
  double direction = 0.0;
  double distance_m = -1.0;
};

struct Cue {
  double time_s = 0.0;          ///< When it should begin to be spoken.
  CueKind kind = CueKind::stop;
  Urgency urgency = Urgency::place;
  bool has_direction = false;
  bool up = false;              ///< Stairs and elevators: upwards.
  double direction = 0.0;       ///< From the chest, radians in (-pi, pi], counter-clockwise (left is positive).
  double distance_m = -1.0;     ///< Negative: not said.
  double sigma_m = 0.0;         ///< How well the distance is known; words grow vaguer with it.
  double time_to_live_s = 2.0;  ///< Too late to be spoken after that.
  int count = 0;                ///< Steps of a flight; 0 when not known.
  RoomIndex room = kNoRoom;
  CueLandmark landmark{};
  CueTail tail{};
};

/// The urgency that cues of a kind have unless the wearer asked.
[[nodiscard]] Urgency urgency_of(CueKind kind) noexcept;
[[nodiscard]] Cue make_cue(CueKind kind) noexcept;

/// The sectors in which directions are told (docs/guidance.md).
enum class Sector : std::uint8_t { ahead, slightly_left, slightly_right, left, right, sharp_left, sharp_right, behind };

/// Ahead within 20 degrees; slightly left or right to 45; left or right to 120; sharp left or right to 160; behind.
[[nodiscard]] Sector sector_of(double direction) noexcept;

}  // namespace echoway
