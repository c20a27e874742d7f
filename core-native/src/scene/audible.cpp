#include "scene/audible.hpp"

#include <algorithm>
#include <vector>

#include "scene/visibility.hpp"

namespace echoway::scene {
namespace {

constexpr double kMapSlack = 0.3;  // Metres: a wall answers a little beyond its end.
constexpr double kBeside = 0.5;   // Metres around the floor's grid to which an estimate may stray.

Bounds places_of(const RoomScene& room) noexcept {
  Bounds places;
  places.include(room.grid_origin);
  places.include(room.grid_origin +
                 room.cell_size * Vec2{static_cast<double>(room.columns), static_cast<double>(room.rows)});
  return places.grown(kBeside);
}

// Sound from beyond a door passes here on its straight way, and what is heard farther on is heard here too.
Bounds doorway_of(const Opening& door) noexcept {
  Bounds doorway;
  doorway.include(door.centre);
  return doorway.grown(std::max(kInDoorway, door.half_width) + kMapSlack);
}

// Keeps what may be heard. Where sight leads to what is beyond the doors goes into `ways`.
void keep_audible(RoomScene& room, const Bounds& places, const SightLimits& limits, std::vector<Bounds>& ways) {
  std::vector<Reflector>& all = room.reflectors;
  std::size_t kept = room.own_reflectors;
  for (std::size_t i = kept; i < all.size(); ++i) {
    const bool beyond = all[i].opening >= 0;
    Bounds from = beyond ? doorway_of(room.openings[static_cast<std::size_t>(all[i].opening)]) : places;
    Candidate c;
    if (!may_answer(room, i, make_box(from.low, from.high), limits, c)) continue;
    all[kept++] = all[i];
    if (!beyond) continue;
    from.include(c.feet.a);
    from.include(c.feet.b);
    ways.push_back(from.grown(kMapSlack));
  }
  all.resize(kept);
}

// Keeps the room's own occluders and those that some sight may have to pass; reflectors know theirs by number.
void keep_obstacles(RoomScene& room, const Bounds& places, const std::vector<Bounds>& ways) {
  std::vector<std::int16_t> number(room.occluders.size(), -1);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < number.size(); ++k) {
    const Segment s = room.occluders[k];
    const auto in_the_way = [&](const Bounds& way) { return !way.misses(s); };
    if (k >= room.own_occluders && places.misses(s) && std::none_of(ways.begin(), ways.end(), in_the_way)) continue;
    number[k] = static_cast<std::int16_t>(kept);
    room.occluders[kept++] = s;
  }
  room.occluders.resize(kept);
  for (Reflector& r : room.reflectors) {
    if (r.own_index >= 0) r.own_index = number[static_cast<std::size_t>(r.own_index)];
  }
}

}  // namespace

void leave_out_inaudible(RoomScene& room, const SightLimits& limits) {
  const Bounds places = places_of(room);
  std::vector<Bounds> ways;
  keep_audible(room, places, limits, ways);
  keep_obstacles(room, places, ways);
  room.reflectors.shrink_to_fit();
  room.occluders.shrink_to_fit();
}

}  // namespace echoway::scene
