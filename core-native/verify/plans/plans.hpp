#pragma once

#include <string>
#include <vector>

#include "echoway/building/building.hpp"

/// Plans made in memory, so that the checks need no files.
namespace echoway::plans {

/// A room bounded by one counter-clockwise loop: its walls, its right-angled concave corners and its convex edges.
[[nodiscard]] Room polygon_room(std::string id, const std::vector<Vec2>& loop);
/// A rectangle with a corner at the origin of its own frame.
[[nodiscard]] Room box_room(std::string id, double width, double height);
/// An L of 6 x 5 m whose inner corner is an edge.
[[nodiscard]] Room l_room(std::string id);
/// A comb: `walls` walls, every other corner of it reflex. Teeth 1 m wide and 3 m deep on a 2 m wide spine. walls % 4
/// == 0.
[[nodiscard]] Room comb_room(std::string id, int walls);

/// A hall of 5 x 4 m, an L-shaped office to its right and a store of 5 x 3 m above the hall.
[[nodiscard]] Building three_rooms();
/// Two rooms of 2.5 x 2.5 and 2.5 x 2 m with a door between them: quick to search.
[[nodiscard]] Building two_closets();
/// The same with everything that guidance can lead to or along: a way out, a place, stairs.
[[nodiscard]] Building guided_closets();
/// One room, no door.
[[nodiscard]] Building alone(Room room);

/// A rigid motion of the plane, with or without a reflection: first mirrored in the y axis, then turned, then shifted.
struct Motion {
  bool mirrored = false;
  double turn = 0.0;
  Vec2 shift{};

  [[nodiscard]] Vec2 apply(Vec2 p) const noexcept;
  [[nodiscard]] double apply_heading(double heading) const noexcept;
};

/// The same room drawn elsewhere, turned or mirrored.
[[nodiscard]] Room moved(Room room, const Motion& motion);

}  // namespace echoway::plans
