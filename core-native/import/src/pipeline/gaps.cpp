#include "pipeline/gaps.hpp"

#include <cstdio>

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kHairline = 0.025;   // metres; half of the widest gap that is always closed
constexpr double kNarrow = 0.2;       // metres; half of the widest gap that nobody fits through
constexpr double kRealSpace = 0.3;    // metres; radius of the largest circle in a space worth parting from another
constexpr double kTouching = 2e-3;    // metres

Shape closed(const Shape& area, double radius) {
  return geos::unite({area, geos::grow(geos::grow(area, radius), -radius)});
}

bool is_real_space(const Shape& area) {
  return area.area() > 1.0 && geos::inscribed_circle(area).radius > kRealSpace;
}

// How many of `spaces` touch `plug`.
int spaces_at(const Shape& plug, const std::vector<Shape>& spaces) {
  int count = 0;
  for (const Shape& space : spaces) count += geos::distance(plug, space) < kTouching ? 1 : 0;
  return count;
}

void report_gap(const Shape& plug, const std::vector<BarrierPart>& parts, const std::string& level, Report& report) {
  std::string ids;
  Source source;
  for (const BarrierPart& part : parts) {
    if (geos::distance(plug, part.shape) > kTouching) continue;
    if (source.file.empty()) {
      source = part.source;
    } else if (part.source.id != source.id) {
      ids += (ids.empty() ? " to " : ", ") + part.source.id;
    }
  }
  const geos::Box box = geos::oriented_box(plug);
  char text[160];
  std::snprintf(text, sizeof text, "the wall has a gap of %.0f x %.0f cm%s: closed", box.length * 100.0,
                box.width * 100.0, ids.c_str());
  report.repaired(source, level, box.centre, text);
}

}  // namespace

Shape close_gaps(const Shape& barrier, const std::vector<BarrierPart>& parts, const Shape& inside,
                 const std::string& level, Report* report) {
  if (barrier.empty()) return barrier;
  const Shape tight = closed(barrier, kHairline);
  const Shape wide = closed(tight, kNarrow);
  // What the widest closing parts from each other; the outside counts as a space of its own.
  std::vector<Shape> spaces;
  for (const Shape& space : geos::areas(geos::difference(geos::grow(inside, 2.0), wide))) {
    if (is_real_space(space)) spaces.push_back(space);
  }
  std::vector<Shape> walls{tight};
  const auto consider = [&](const Shape& plugs, bool add) {
    for (const Shape& plug : geos::areas(plugs)) {
      if (plug.area() > 1.0 || spaces_at(plug, spaces) < 2) continue;
      if (add) walls.push_back(plug);
      if (report != nullptr && plug.area() > 1e-4) report_gap(plug, parts, level, *report);
    }
  };
  consider(geos::difference(tight, barrier), false);
  consider(geos::difference(wide, tight), true);
  return geos::unite(walls);
}

}  // namespace echoway::import
