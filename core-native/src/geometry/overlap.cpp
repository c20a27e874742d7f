#include "geometry/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "echoway/geometry/inclusion.hpp"

namespace echoway {
namespace {

using Loops = std::span<const std::vector<Vec2>>;

template <class Visit>
void for_each_edge(Loops loops, Visit visit) {
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) visit(Segment{loop[j], loop[i]});
  }
}

bool is_deep_inside(Loops loops, Vec2 p, double tolerance) {
  if (classify(loops, p) != Inclusion::inside) return false;
  bool deep = true;
  for_each_edge(loops, [&](const Segment& edge) { deep = deep && distance(edge, p) > tolerance; });
  return deep;
}

/// Where `edge` crosses the walls of `loops`, as shares of its length, with its two ends.
std::vector<double> crossings(const Segment& edge, Loops loops) {
  std::vector<double> shares{0.0, 1.0};
  for_each_edge(loops, [&](const Segment& wall) {
    const double denominator = cross(edge.direction(), wall.direction());
    if (denominator == 0.0) return;
    const double s = cross(wall.a - edge.a, wall.direction()) / denominator;
    const double t = cross(wall.a - edge.a, edge.direction()) / denominator;
    if (s > 0.0 && s < 1.0 && t >= 0.0 && t <= 1.0) shares.push_back(s);
  });
  std::sort(shares.begin(), shares.end());
  return shares;
}

/// Between two crossings an edge is wholly inside the other floor or wholly outside: its middle tells.
bool walls_run_inside(Loops a, Loops b, double tolerance) {
  bool found = false;
  for_each_edge(a, [&](const Segment& edge) {
    if (found) return;
    const std::vector<double> shares = crossings(edge, b);
    for (std::size_t i = 1; i < shares.size() && !found; ++i) {
      const double middle = 0.5 * (shares[i - 1] + shares[i]);
      found = is_deep_inside(b, edge.a + middle * edge.direction(), tolerance);
    }
  });
  return found;
}

}  // namespace

Vec2 interior_point(Loops floor) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for_each_edge(floor, [&](const Segment& edge) {
    low = std::min(low, edge.a.y);
    high = std::max(high, edge.a.y);
  });
  Vec2 best{};
  double widest = -1.0;
  // A few heights at odd shares of the room's, so that a wall along one of them does no harm.
  for (const double share : {0.5, 0.31, 0.73, 0.12, 0.91}) {
    const double y = low + share * (high - low);
    std::vector<double> xs;
    for_each_edge(floor, [&](const Segment& edge) {
      if ((edge.a.y > y) == (edge.b.y > y)) return;
      xs.push_back(edge.a.x + (y - edge.a.y) / (edge.b.y - edge.a.y) * (edge.b.x - edge.a.x));
    });
    std::sort(xs.begin(), xs.end());
    for (std::size_t i = 1; i < xs.size(); i += 2) {
      if (xs[i] - xs[i - 1] > widest) {
        widest = xs[i] - xs[i - 1];
        best = {0.5 * (xs[i] + xs[i - 1]), y};
      }
    }
  }
  return best;
}

bool floors_overlap(Loops a, Loops b, double tolerance) {
  // Floors whose walls coincide share ground without any wall of one inside the other.
  return walls_run_inside(a, b, tolerance) || walls_run_inside(b, a, tolerance) ||
         is_deep_inside(b, interior_point(a), tolerance) || is_deep_inside(a, interior_point(b), tolerance);
}

}  // namespace echoway
