#pragma once

#include <span>
#include <vector>

#include "echoway/geometry/segment.hpp"
#include "echoway/units.hpp"

namespace echoway {

/// Walls whose ends come this close are taken to meet (2 in): what a drawing leaves open by carelessness, and less than
/// anything that a wearer or an echo passes.
inline constexpr double kSnapDistance = 0.05;

/// Points nearer than this are one point.
inline constexpr double kSamePoint = 1e-3;

/// Two walls that meet, seen from the floor.
struct WallMeeting {
  Vec2 at{};
  double angle = 0.0;  ///< Of the floor between the walls, (0, 2 pi]; 2 pi at the free end of a screen.
};

/// An end of a wall that meets nothing.
struct FreeEnd {
  std::size_t wall = 0;  ///< Index into the walls.
  Vec2 at{};
};

/// A free end that was moved by at most kSnapDistance to close a gap.
struct SnappedEnd {
  std::size_t wall = 0;
  Vec2 at{};
  double moved = 0.0;
};

/// The floor that a room's walls enclose.
struct FloorTrace {
  bool closed = false;                      ///< Whether walls enclose a floor; else only free_ends means anything.
  std::vector<std::vector<Vec2>> boundary;  ///< Outer loop counter-clockwise, then holes clockwise.
  std::vector<WallMeeting> meetings;        ///< All around the floor, screens and holes included.
  std::vector<FreeEnd> free_ends;           ///< Ends of screens, and of walls that stick out of the room.
  std::vector<SnappedEnd> snapped;
  std::vector<std::size_t> outside_walls;  ///< Walls that neither touch the floor nor join those that do, ascending.
  double cut_off_area = 0.0;               ///< Of the largest other enclosure joined to the floor's outer walls, m^2.
};

/// Finds the floor by way of the planar graph of the walls: ends closer than kSamePoint are one vertex, walls are split
/// where another wall meets or crosses them, free ends within kSnapDistance of a wall are joined to it. The floor is
/// the largest bounded face; other bounded faces are solid (columns, shafts). A wall with the floor on both sides is a
/// screen: it reflects, but bounds nothing.
///
/// Not closed when no face is bounded, or when walls cross each other thousands of times, or when walls that stand
/// outside every bounded face are longer than a quarter of the outer loop: then what should be the floor leaks into the
/// open, and the bounded face is some alcove or column.
[[nodiscard]] FloorTrace trace_floor(std::span<const Segment> walls);

/// From a free end to the nearest other wall, metres; infinite when there is none.
[[nodiscard]] double gap_at(std::span<const Segment> walls, const FreeEnd& end);

}  // namespace echoway
