#pragma once

#include <optional>
#include <string>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/import/report.hpp"
#include "geometry/geos.hpp"

/// What every source format is read into: the plan of a venue in its own words, before any geometry is worked out.
/// Readers fill coordinates with degrees (x longitude, y latitude); project_plan() turns them into metres in place.
namespace echoway::import {

using Path = std::vector<Vec2>;
using Area = std::vector<geos::Polygon2>;

enum class UnitKind {
  room,      ///< Bounded by walls along its polygon.
  open,      ///< Floor without walls of its own: corridors, lobbies, areas.
  zone,      ///< A name for a piece of floor that walls drawn elsewhere bound.
  stairs,    ///< Stairs, escalators and ramps between levels.
  elevator,
  solid,     ///< Columns, shafts, structure: nobody stands there, sound comes back from it.
  opening,   ///< A hole in the floor, railed off.
  outdoors,  ///< Terraces, gardens: not a room; a door to it leads out.
};

struct PlanUnit {
  Source source;
  UnitKind kind = UnitKind::room;
  Area area;
  std::string name;      ///< What people call it; empty when the plan does not say.
  std::string number;    ///< Door sign, such as 2.14.
  std::string category;  ///< The source's own word.
  std::string shaft;     ///< Units of the same shaft on different levels are joined; empty: by where they lie.
};

/// A wall, window, column or other thing that sound does not pass: an area, or a path with a thickness.
struct PlanWall {
  Source source;
  Area area;
  Path path;
  double thickness = 0.0;
};

/// A door or an opening: an area in the wall, a line across the opening, or a point on the wall.
struct PlanDoor {
  Source source;
  Area area;
  Path path;                ///< Two points: the ends of the opening; one: its centre.
  double width = 0.0;       ///< Metres, 0 when the plan does not say.
  bool way_out = false;     ///< The plan says that it leads out of the building.
  std::string name;
};

struct PlanFurniture {
  Source source;
  Area area;
  Path path;
};

struct PlanAmenity {
  Source source;
  Vec2 at{};
  std::string name;
  std::string category;
};

/// A line along which people walk. Its name tells what the space is called through which it leads.
struct PlanPathway {
  Source source;
  Path path;
  std::string name;
  bool entrance = false;
};

struct PlanLevel {
  int ordinal = 0;
  std::string short_name;
  std::string name;
  std::string file;
  bool ground = false;  ///< Doors in outer walls lead out of the building.
  Area outline;         ///< All that lies in it and is no wall is floor; empty when only units tell where the floor is.
  std::vector<PlanUnit> units;
  std::vector<PlanWall> walls;
  std::vector<PlanDoor> doors;
  std::vector<PlanFurniture> furniture;
  std::vector<PlanAmenity> amenities;
  std::vector<PlanPathway> pathways;
};

/// One end of a declared link: a unit by its id, or a point.
struct PlanLinkEnd {
  int ordinal = 0;
  std::string unit;
  std::optional<Vec2> at;
};

struct PlanLink {
  Source source;
  LevelLinkKind kind = LevelLinkKind::stairs;
  PlanLinkEnd a, b;
};

struct Plan {
  std::string file;
  std::string name;
  std::vector<PlanLevel> levels;  ///< In order of their ordinals, each ordinal once.
  std::vector<PlanLink> links;
};

}  // namespace echoway::import
