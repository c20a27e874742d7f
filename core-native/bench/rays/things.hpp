#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/random.hpp"

namespace echoway::rays {

/// Where the way between two points crosses a segment, if it does.
[[nodiscard]] std::optional<Vec2> crossing(const Segment& segment, Vec2 from, Vec2 to) noexcept;

/// A post or a person, seen from above.
struct Disc {
  Vec2 centre{};
  double radius = 0.0;
};

/// What stands on a level, in the level's frame: the plan, its doors open, and what no plan shows.
struct Things {
  std::vector<Segment> planes;        ///< Walls, and the sides of cupboards.
  std::size_t walls = 0;              ///< The first of these are walls.
  std::vector<Segment> benches;       ///< Answer at any incidence.
  std::vector<Vec2> corners;
  std::vector<Vec2> edges;            ///< Door jambs, the corners of cupboards.
  std::vector<Disc> posts;
  std::vector<Disc> people;

  /// Whether nothing stands between two points; what touches either of them does not count.
  [[nodiscard]] bool in_sight(Vec2 from, Vec2 to) const noexcept;
};

/// The plan of a building of one level, furnished by chance: cupboards and posts keep clear of `way`, where the wearer
/// goes, and of doors.
[[nodiscard]] Things furnish(const Building& building, std::span<const Vec2> way, Random& random);

}  // namespace echoway::rays
