#include "surface.hpp"

#include <algorithm>

#include "echoway/geometry/box.hpp"
#include "following.hpp"

namespace echoway::report {
namespace {

constexpr double kApart = feet(2.0);
constexpr double kAsGood = 0.25;

}  // namespace

const Surface::Point& Surface::lowest() const {
  return *std::min_element(points.begin(), points.end(),
                           [](const Point& a, const Point& b) { return a.objective_m < b.objective_m; });
}

int Surface::rivals() const {
  std::vector<double> values;
  for (const Point& point : points) values.push_back(point.objective_m);
  const Point best = lowest();
  const double limit = best.objective_m + kAsGood * (quantile(std::move(values), 0.5) - best.objective_m);
  std::vector<Point> low;
  std::copy_if(points.begin(), points.end(), std::back_inserter(low),
               [&](const Point& p) { return p.objective_m < limit; });
  std::sort(low.begin(), low.end(), [](const Point& a, const Point& b) { return a.objective_m < b.objective_m; });
  std::vector<Vec2> minima;
  for (const Point& point : low) {
    const auto near = [&](Vec2 other) { return distance(other, point.at) <= kApart; };
    const bool lowest_about = std::none_of(low.begin(), low.end(), [&](const Point& other) {
      return other.objective_m < point.objective_m && distance(other.at, point.at) <= kApart;
    });
    if (lowest_about && std::none_of(minima.begin(), minima.end(), near)) minima.push_back(point.at);
  }
  return static_cast<int>(minima.size()) - 1;
}

Surface Surface::within(Vec2 centre, double radius) const {
  Surface part;
  std::copy_if(points.begin(), points.end(), std::back_inserter(part.points),
               [&](const Point& p) { return distance(p.at, centre) <= radius; });
  return part;
}

Surface error_surface(RoomMatcher& matcher, const thesis::Scan& scan, double heading, const Room& room,
                      double spacing_m) {
  const auto [low, high] = box_about(room.boundary);
  Surface surface;
  for (int i = 1; low.x + i * spacing_m < high.x; ++i) {
    for (int j = 1; low.y + j * spacing_m < high.y; ++j) {
      const Vec2 at{low.x + i * spacing_m, low.y + j * spacing_m};
      if (const auto objective = matcher.objective(scan, {at, heading})) surface.points.push_back({at, *objective});
    }
  }
  return surface;
}

}  // namespace echoway::report
