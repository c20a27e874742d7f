#pragma once

#include <span>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/building/opening.hpp"
#include "echoway/routing/segment_tree.hpp"

namespace echoway {

/// A door as a walker in one of its rooms sees it: where to pass, and which way is into the room.
struct Passage {
  std::int32_t door = -1;  ///< Index into Building::doors.
  Vec2 centre{};           ///< On the wall, in the room's frame; the door's own point when no wall is near it.
  Vec2 inward{};           ///< Unit normal into the room; zero when no wall is near.
};

/// Where a walker's centre may be in one room: its walls with the doors cut out and its all-reflective elements are
/// solid; screens and pillars need no special case. All coordinates are metres in the room's frame.
///
/// A "clearance" is the distance to the nearest solid thing; a walker of half-width r fits where clearance >= r.
class FreeSpace {
 public:
  FreeSpace(const Building& building, RoomIndex room);

  [[nodiscard]] std::span<const Segment> solids() const noexcept { return solids_.segments(); }
  /// The pieces that doors cut out of the walls.
  [[nodiscard]] std::span<const Segment> doorways() const noexcept { return doorways_; }
  [[nodiscard]] std::span<const Passage> passages() const noexcept { return passages_; }

  /// True inside the room's outline and outside its holes: even-odd over the boundary, or over the walls when the room
  /// has no boundary (then three rays vote, since screens disturb a count).
  [[nodiscard]] bool contains(Vec2 p) const noexcept;

  /// Distance to the nearest solid, at most `limit`.
  [[nodiscard]] double clearance(Vec2 p, double limit = 1e9) const noexcept {
    return solids_.nearest(p, limit).distance;
  }
  [[nodiscard]] SegmentTree::Nearest nearest_solid(Vec2 p, double limit = 1e9) const noexcept {
    return solids_.nearest(p, limit);
  }

  /// True when a walker of half-width `radius` may go straight from `a` to `b` without leaving the room.
  [[nodiscard]] bool clear(Vec2 a, Vec2 b, double radius) const noexcept;

  /// As clear(), but a walker who already stands closer than `radius` to something at `a` or must stand so at `b` may:
  /// the way comes no closer to it than its own ends do.
  [[nodiscard]] bool clear_between(Vec2 a, Vec2 b, double radius) const noexcept;

  /// As clear_between(), straight from `a` to the centre of one of this room's passages.
  [[nodiscard]] bool clear_to_door(Vec2 a, const Passage& passage, double radius) const noexcept;

  /// How far a point can go from `p` along `unit` before it meets something solid, at most `limit`. Open doors let it
  /// through.
  [[nodiscard]] double reach(Vec2 p, Vec2 unit, double limit) const noexcept { return solids_.ray(p, unit, limit); }

  /// The point near `p` with at least `radius` of clearance, or with the best that a few pushes away from the walls
  /// find; always inside the room when any point near `p` is.
  [[nodiscard]] Vec2 settle(Vec2 p, double radius) const noexcept;

 private:
  void add_passage(const Door& door, std::int32_t index, Vec2 at, std::vector<DoorOpening>& openings);
  [[nodiscard]] bool keeps_away(const Segment& way, double radius) const noexcept;
  [[nodiscard]] bool crosses_doorway(const Segment& s) const noexcept;

  const Room* room_;
  SegmentTree solids_;
  std::vector<Passage> passages_;
  std::vector<Segment> doorways_;
};

}  // namespace echoway
