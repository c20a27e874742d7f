#include <algorithm>
#include <cmath>
#include <limits>

#include "building/lint.hpp"
#include "building/phrases.hpp"
#include "echoway/geometry/box.hpp"
#include "echoway/geometry/inclusion.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

// Nobody walks in less, nothing is built larger; lengths in metres.
constexpr double kSmallestArea = 0.25;
constexpr double kNarrowest = 0.3;
constexpr double kWidest = 300.0;

// A building none of whose rooms has 4 m^2 is drawn in metres and read as feet; one all of whose rooms are larger than
// 60 m both ways is drawn in inches or less.
constexpr double kLargestRoomAtLeast = 4.0;
constexpr double kSmallestRoomAtMost = 60.0;

/// Beyond this, coordinates are those of a country, not of a building, and lose digits for nothing.
constexpr double kFarAway = 1e5;

struct Extent {
  double width = 0.0;
  double height = 0.0;
  double farthest = 0.0;
};

Extent extent_of(const Room& room) {
  const auto [low, high] = box_about(room.walls);
  const double farthest = std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  return {high.x - low.x, high.y - low.y, farthest};
}

double floor_area(const Room& room) {
  double area = 0.0;
  for (const std::vector<Vec2>& loop : room.boundary) area += signed_area(loop);
  return area;
}

}  // namespace

void lint_sizes(const Assembly& assembly, Findings& findings) {
  const Building& building = assembly.building;
  const Phrases phrases(building.unit);
  const std::string unit = building.unit == LengthUnit::feet ? "ft" : "m";
  const std::string ask_for_unit = "; lengths are taken as " + unit + ", check the 'units' line of building.cfg";
  double largest_area = 0.0;
  double smallest_side = std::numeric_limits<double>::infinity();
  bool any = false;
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    if (!assembly.floors[i].closed) continue;
    any = true;
    const RoomSource& source = assembly.source.rooms[i];
    const Extent extent = extent_of(building.rooms[i]);
    const auto [narrow, wide] = std::minmax({extent.width, extent.height});
    const double area = floor_area(building.rooms[i]);
    largest_area = std::max(largest_area, area);
    smallest_side = std::min(smallest_side, narrow);
    const std::string size = phrases.length(extent.width) + " by " + phrases.length(extent.height);
    if (narrow < kNarrowest || area < kSmallestArea) {
      findings.warn(Kind::size, source.file, source.counts_line, "the room is absurdly small, " + size + ask_for_unit);
    } else if (wide > kWidest) {
      findings.warn(Kind::size, source.file, source.counts_line, "the room is absurdly large, " + size + ask_for_unit);
    }
    if (extent.farthest > kFarAway) {
      findings.warn(Kind::far_origin, source.file, source.counts_line,
                    "the room lies " + phrases.length(extent.farthest) +
                        " from the origin of its own frame; put the origin at one of its corners");
    }
  }
  if (!any) return;
  const std::string& config = assembly.source.config.file;
  if (largest_area < kLargestRoomAtLeast) {
    findings.warn(Kind::size, config, 0, "the largest room has only " + phrases.area(largest_area) + ask_for_unit);
  }
  if (smallest_side > kSmallestRoomAtMost) {
    findings.warn(Kind::size, config, 0,
                  "every room is more than " + phrases.length(kSmallestRoomAtMost) + " wide" + ask_for_unit);
  }
}

}  // namespace echoway
