#include <algorithm>
#include <limits>

#include "scene/room_scene.hpp"

namespace echoway::scene {

bool FloorLoops::contains(Vec2 p) const noexcept {
  bool inside = false;
  for (std::size_t l = 0; l + 1 < begin.size(); ++l) {
    Vec2 u = vertices[begin[l + 1] - 1];
    for (std::size_t i = begin[l]; i < begin[l + 1]; ++i) {
      const Vec2 v = vertices[i];
      if ((u.y > p.y) != (v.y > p.y)) {
        const double side = cross(v - u, p - u);
        if ((v.y > u.y) ? side > 0.0 : side < 0.0) inside = !inside;
      }
      u = v;
    }
  }
  return inside;
}

double FloorLoops::distance(Vec2 p) const noexcept {
  double best2 = std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l + 1 < begin.size(); ++l) {
    Vec2 u = vertices[begin[l + 1] - 1];
    for (std::size_t i = begin[l]; i < begin[l + 1]; ++i) {
      const Vec2 v = vertices[i];
      best2 = std::min(best2, squared_norm(p - nearest_point({u, v}, p)));
      u = v;
    }
  }
  return std::sqrt(best2);
}

bool FloorLoops::crossed_by_box(Vec2 low, Vec2 high) const noexcept {
  const Vec2 centre = 0.5 * (low + high);
  const Vec2 half = 0.5 * (high - low);
  for (std::size_t l = 0; l + 1 < begin.size(); ++l) {
    Vec2 u = vertices[begin[l + 1] - 1];
    for (std::size_t i = begin[l]; i < begin[l + 1]; ++i) {
      const Vec2 v = vertices[i];
      const bool apart_x = std::max(u.x, v.x) < low.x || std::min(u.x, v.x) > high.x;
      const bool apart_y = std::max(u.y, v.y) < low.y || std::min(u.y, v.y) > high.y;
      if (!apart_x && !apart_y) {
        const Vec2 d = v - u;
        const double reach = std::abs(d.x) * half.y + std::abs(d.y) * half.x;
        if (std::abs(cross(d, centre - u)) <= reach) return true;
      }
      u = v;
    }
  }
  return false;
}

}  // namespace echoway::scene
