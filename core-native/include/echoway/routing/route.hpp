#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "echoway/building/building.hpp"

namespace echoway {

/// How far to stay from walls: the first where there is room for it, the next where there is not, each making a metre
/// walked count for more. The last is the least a walker needs; what is narrower counts as closed.
struct ClearanceStep {
  double radius = 0.0;       ///< Metres from the walker's axis.
  double cost_factor = 1.0;  ///< Cost of a metre walked with it.
};
inline constexpr int kClearanceSteps = 3;
using ClearanceLadder = std::array<ClearanceStep, kClearanceSteps>;

struct RouterConfig {
  /// Half the breadth of a clothed adult's shoulders is 0.25 m (ISO 7250, 95th percentile 0.50 m); the rest is sway.
  ClearanceLadder clearances{{{0.45, 1.0}, {0.35, 1.25}, {0.25, 1.6}}};
  double door_run_up_m = 0.8;      ///< Straight towards a door's centre over this length where there is room for it.
  double stairs_cost_m = 12.0;     ///< Metres of level walking that a flight of stairs counts for.
  double elevator_cost_m = 25.0;   ///< The same for an elevator, waiting included.
  /// Added per flight when stairs are to be avoided: taken only if nothing else leads there.
  double avoided_cost_m = 10000.0;
};

/// A spot in a building.
struct Spot {
  RoomIndex room = kNoRoom;
  Vec2 at{};  ///< In the room's frame.
};

/// Where to go.
struct Goal {
  enum class Kind : std::uint8_t {
    spot,
    place,        ///< `index` into Building::places.
    exit,         ///< `index` into Building::exits.
    nearest_exit,
    room,         ///< Anywhere inside room `index`.
  } kind = Kind::spot;
  std::int32_t index = -1;
  Spot spot{};    ///< For Kind::spot.

  friend constexpr bool operator==(const Goal& a, const Goal& b) noexcept {
    return a.kind == b.kind && a.index == b.index && a.spot.room == b.spot.room && a.spot.at == b.spot.at;
  }
};

struct RoutePreferences {
  bool avoid_stairs = false;
};

enum class WaypointKind : std::uint8_t {
  start,
  turn,       ///< About a corner, or in front of a door.
  door,       ///< The centre of Building::doors[index]; `room` is the one being left.
  link_from,  ///< Where Building::links[index] is taken.
  link_to,    ///< Where it arrives; `room` is the new one.
  goal,
};

struct Waypoint {
  RoomIndex room = kNoRoom;
  Vec2 at{};                ///< In the room's frame.
  WaypointKind kind = WaypointKind::turn;
  std::int32_t index = -1;  ///< Door or link.
  RoomIndex next_room = kNoRoom;  ///< Doors only: the room that is entered,
  Vec2 next_at{};                 ///< and the same point in its frame.
};

/// A safe way, waypoint by waypoint; straight in between. At a door the next waypoint is in the next room's frame.
struct Route {
  std::vector<Waypoint> waypoints;
  double length_m = 0.0;     ///< Walked, stairs counted with their configured cost.
  double cost = 0.0;         ///< What was minimised: length with narrow places and avoided stairs counting for more.
  /// The least that it keeps from walls, doorways apart. Below the first step: a narrow place. 0 without a way.
  double clearance_m = 0.0;
  bool uses_stairs = false;
  bool uses_elevator = false;
  Goal goal{};               ///< What it leads to; for nearest_exit the exit that was chosen.

  [[nodiscard]] bool narrow(const RouterConfig& config) const noexcept {
    return !waypoints.empty() && clearance_m < config.clearances.front().radius - 1e-6;
  }
  void clear() noexcept {
    waypoints.clear();
    length_m = cost = clearance_m = 0.0;
    uses_stairs = uses_elevator = false;
  }
};

/// The door or the stairs by which a walker is already leaving a room: others are taken only where they save more.
struct BoundFor {
  WaypointKind kind = WaypointKind::turn;  ///< door or link_from; anything else: bound for none.
  std::int32_t index = -1;
  double worth_m = 0.0;                    ///< Cost that another way out has to save.
};

/// Length of a route's walked part, metres, stairs and elevators left out.
[[nodiscard]] double walked_length(const Route& route) noexcept;

}  // namespace echoway
