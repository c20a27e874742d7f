#include "pipeline/door_sides.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace echoway::import {
namespace {

using geos::Shape;
using Kind = DoorSide::Kind;

constexpr double kStep = 0.02;   // metres between looks
constexpr double kInset = 1e-3;  // metres; a look this far inside a cell is certain

}  // namespace

DoorLooker::DoorLooker(const LevelFloor& floor) : floor_(floor), enclosed_(geos::fill_holes(floor.inside)) {}

DoorSides DoorLooker::within(const DoorCandidate& door, double reach) const {
  const Vec2 n = perpendicular(door.along);
  return {look(door, n, reach), look(door, -n, reach)};
}

DoorSides DoorLooker::through_wall(const DoorCandidate& door) const {
  DoorSides sides = within(door, kWallReach);
  const Vec2 n = perpendicular(door.along);
  look_further(door, n, sides.back, sides.front);
  look_further(door, -n, sides.front, sides.back);
  return sides;
}

void DoorLooker::look_further(const DoorCandidate& door, Vec2 n, const DoorSide& near, DoorSide& far) const {
  if (near.kind != Kind::cell || far.kind == Kind::cell) return;
  if (geos::contains(floor_.outdoors, door.centre + kWallReach * n)) return;
  const DoorSide beyond = look(door, n, kThickestWall - near.distance);
  if (beyond.kind == Kind::cell && beyond.cell != near.cell) far = beyond;
}

// Three looks across the door's width, and what most of them see. Where each sees something else, it is what the middle
// one sees or, when that is a wall, what is more of a door: nothing hangs on which end of the door is looked at first.
DoorSide DoorLooker::look(const DoorCandidate& door, Vec2 n, double reach) const {
  std::array<DoorSide, 3> looks{};
  for (int i = -1; i <= 1; ++i) {
    looks[static_cast<std::size_t>(i + 1)] = look_from(door.centre + (0.25 * i * door.width) * door.along, n, reach);
  }
  const auto claim = [&looks](const DoorSide& s) {
    const auto votes = std::ranges::count_if(looks, [&s](const DoorSide& t) { return same_beyond(s, t); });
    return std::tuple(votes, s.kind != Kind::blocked, same_beyond(s, looks[1]), -static_cast<int>(s.kind), -s.cell);
  };
  DoorSide best = *std::ranges::max_element(looks, {}, claim);
  for (const DoorSide& s : looks) {
    if (same_beyond(s, best)) best.distance = std::min(best.distance, s.distance);
  }
  return best;
}

DoorSide DoorLooker::look_from(Vec2 from, Vec2 n, double reach) const {
  for (double d = kInset; d <= reach; d += kStep) {
    const int cell = floor_.cell_at(from + d * n);
    if (cell >= 0) return {Kind::cell, cell, refine(from, n, d, cell)};
  }
  return nothing_at(from + reach * n, reach);
}

DoorSide DoorLooker::nothing_at(Vec2 p, double reach) const {
  if (geos::contains(floor_.outdoors, p)) return {Kind::outside, -1, reach};
  if (geos::contains(floor_.inside, p)) return {Kind::blocked, -1, reach};
  return {geos::contains(enclosed_, p) ? Kind::court : Kind::outside, -1, reach};
}

// Where exactly the cell begins, to a tenth of a millimetre.
double DoorLooker::refine(Vec2 from, Vec2 n, double inside, int cell) const {
  const Shape& area = floor_.cells[static_cast<std::size_t>(cell)].floor;
  double outside = std::max(0.0, inside - kStep);
  while (inside - outside > geos::kGrid) {
    const double middle = 0.5 * (inside + outside);
    (geos::contains(area, from + middle * n) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace echoway::import
