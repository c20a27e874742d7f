#include "pipeline/project.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "source/limits.hpp"
#include "source/source_error.hpp"

namespace echoway::import {
namespace {

constexpr double kSamePoint = 1e-3;  // metres; nearer points are one point twice
constexpr double kNoArea = 1e-4;     // square metres

// Calls `use(path)` for every list of coordinates of a feature.
template <class Feature, class Use>
void for_each_path(Feature& feature, Use use) {
  if constexpr (requires { feature.area; }) {
    for (auto& polygon : feature.area) {
      use(polygon.outer);
      for (auto& hole : polygon.holes) use(hole);
    }
  }
  if constexpr (requires { feature.path; }) use(feature.path);
  if constexpr (requires { feature.at; }) {
    Path one{feature.at};
    use(one);
    feature.at = one.front();
  }
}

template <class Use>
void for_each_list(PlanLevel& level, Use use) {
  use(level.units);
  use(level.walls);
  use(level.doors);
  use(level.furniture);
  use(level.amenities);
  use(level.pathways);
}

// Degrees of longitude measured from `from`, so that a building on the antimeridian stays in one piece.
double turn_from(double lon, double from) { return std::remainder(lon - from, 360.0); }

// The median vertex: the middle of the building's own features whatever strays there are.
LonLat median_vertex(Plan& plan) {
  std::vector<double> lons, lats;
  for (PlanLevel& level : plan.levels) {
    for_each_list(level, [&](auto& list) {
      for (auto& feature : list) {
        for_each_path(feature, [&](Path& path) {
          for (const Vec2 p : path) {
            lons.push_back(p.x);
            lats.push_back(p.y);
          }
        });
      }
    });
  }
  if (lons.empty()) throw SourceError(Error{"holds no floor plan: no feature with coordinates", plan.file, 0});
  if (lons.size() > kMaxVertices) throw SourceError(Error{"holds too many points for a floor plan", plan.file, 0});
  const auto middle = static_cast<std::ptrdiff_t>(lons.size() / 2);
  std::nth_element(lats.begin(), lats.begin() + middle, lats.end());
  const double first = lons.front();
  std::nth_element(lons.begin(), lons.begin() + middle, lons.end(),
                   [first](double a, double b) { return turn_from(a, first) < turn_from(b, first); });
  return {lons[static_cast<std::size_t>(middle)], lats[static_cast<std::size_t>(middle)]};
}

void drop_strays(Plan& plan, const LocalProjection& near, Report& report) {
  for (PlanLevel& level : plan.levels) {
    for_each_list(level, [&](auto& list) {
      std::erase_if(list, [&](auto& feature) {
        bool far = false;
        for_each_path(feature, [&](Path& path) {
          for (const Vec2 p : path) {
            // The tangent plane folds the far side of the earth back, so the angle is looked at as well.
            far = far || norm(near.to_metres({p.x, p.y})) > kMaxExtent || std::abs(p.y - near.origin().lat) > 1.0 ||
                  std::abs(turn_from(p.x, near.origin().lon)) > 90.0;
          }
        });
        if (far) {
          report.unresolved(feature.source, level.short_name, {}, "lies far from the rest of the plan: left out");
        }
        return far;
      });
    });
  }
}

LonLat centre_of(Plan& plan, LonLat median) {
  Vec2 low{1e9, 1e9}, high{-1e9, -1e9};
  for (PlanLevel& level : plan.levels) {
    for_each_list(level, [&](auto& list) {
      for (auto& feature : list) {
        for_each_path(feature, [&](Path& path) {
          for (const Vec2 p : path) {
            const double lon = turn_from(p.x, median.lon);
            low = {std::min(low.x, lon), std::min(low.y, p.y)};
            high = {std::max(high.x, lon), std::max(high.y, p.y)};
          }
        });
      }
    });
  }
  // Seven decimals, a centimetre: the origin can be written down and used again.
  const auto rounded = [](double degree) { return std::round(degree * 1e7) / 1e7; };
  return {rounded(median.lon + 0.5 * (low.x + high.x)), rounded(0.5 * (low.y + high.y))};
}

double signed_area(const Path& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  return 0.5 * twice;
}

std::size_t drop_repeats(Path& path, bool ring) {
  const std::size_t before = path.size();
  path.erase(std::unique(path.begin(), path.end(), [](Vec2 a, Vec2 b) { return distance(a, b) < kSamePoint; }),
             path.end());
  while (ring && path.size() > 1 && distance(path.front(), path.back()) < kSamePoint) path.pop_back();
  return before - path.size();
}

// A hole outside its outline takes nothing out; left in, it would become a room of its own.
void drop_outside_holes(geos::Polygon2& polygon, const Source& source, const std::string& level, Report& report) {
  if (polygon.holes.empty() || geos::is_valid(polygon)) return;
  const geos::Shape inside = geos::area_of({polygon.outer, {}});
  std::erase_if(polygon.holes, [&](const Path& hole) {
    const bool outside = geos::intersection(inside, geos::area_of({hole, {}})).area() < kNoArea;
    if (outside) report.unresolved(source, level, hole.front(), "a hole lies outside its outline: left out");
    return outside;
  });
}

// Makes one feature's polygons safe to use. Returns false when nothing of them is left.
bool clean_area(Area& area, const Source& source, const std::string& level, Report& report) {
  std::size_t repeats = 0;
  Area kept;
  for (geos::Polygon2& polygon : area) {
    repeats += drop_repeats(polygon.outer, true);
    for (Path& hole : polygon.holes) repeats += drop_repeats(hole, true);
    std::erase_if(polygon.holes, [](const Path& hole) { return hole.size() < 3; });
    if (polygon.outer.size() < 3 || std::abs(signed_area(polygon.outer)) < kNoArea) continue;
    drop_outside_holes(polygon, source, level, report);
    const Vec2 at = polygon.outer.front();
    const geos::Shape on_grid = geos::area_of(polygon);
    if (on_grid.empty()) continue;  // a sliver that is narrower than the grid
    if (geos::is_valid(polygon)) {
      kept.push_back(std::move(polygon));
      continue;
    }
    report.repaired(source, level, at, "its outline crosses itself: split into areas that do not");
    for (const geos::Shape& part : geos::areas(on_grid)) kept.push_back(geos::to_polygon(part));
  }
  if (repeats > 0 && !kept.empty()) {
    report.repaired(source, level, kept.front().outer.front(),
                    std::to_string(repeats) + (repeats == 1 ? " repeated point" : " repeated points") + " dropped");
  }
  const bool lost = kept.empty() && !area.empty();
  area = std::move(kept);
  return !lost;
}

void note_winding(const PlanLevel& level, Report& report) {
  std::size_t clockwise = 0, all = 0;
  const auto count = [&](const auto& list) {
    for (const auto& feature : list) {
      for (const geos::Polygon2& polygon : feature.area) {
        ++all;
        if (signed_area(polygon.outer) < 0.0) ++clockwise;
      }
    }
  };
  count(level.units);
  count(level.walls);
  count(level.doors);
  if (clockwise == 0) return;
  report.repaired({level.file, ""}, level.short_name, {},
                  std::to_string(clockwise) + " of " + std::to_string(all) + " outlines run clockwise: turned");
}

void clean(PlanLevel& level, Report& report) {
  note_winding(level, report);
  for_each_list(level, [&](auto& list) {
    std::erase_if(list, [&](auto& feature) {
      if constexpr (requires { feature.path; }) drop_repeats(feature.path, false);
      if constexpr (requires { feature.area; }) {
        if (!clean_area(feature.area, feature.source, level.short_name, report)) {
          report.unresolved(feature.source, level.short_name, {}, "its outline encloses nothing: left out");
          return true;
        }
      }
      return false;
    });
  });
  clean_area(level.outline, {level.file, ""}, level.short_name, report);
}

}  // namespace

LocalProjection project_plan(Plan& plan, Report& report) {
  const LonLat median = median_vertex(plan);
  drop_strays(plan, LocalProjection(median), report);
  const LocalProjection projection(centre_of(plan, median));
  const auto to_metres = [&](Path& path) {
    for (Vec2& p : path) p = projection.to_metres({p.x, p.y});
  };
  for (PlanLevel& level : plan.levels) {
    for_each_list(level, [&](auto& list) {
      for (auto& feature : list) for_each_path(feature, to_metres);
    });
    for (geos::Polygon2& polygon : level.outline) {
      to_metres(polygon.outer);
      for (Path& hole : polygon.holes) to_metres(hole);
    }
    clean(level, report);
  }
  for (PlanLink& link : plan.links) {
    for (PlanLinkEnd* end : {&link.a, &link.b}) {
      if (end->at) end->at = projection.to_metres({end->at->x, end->at->y});
    }
  }
  return projection;
}

}  // namespace echoway::import
