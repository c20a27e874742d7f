#include "thesis/floor.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::thesis {

Floor::Floor(const Room& room) {
  for (const auto& loop : room.boundary) {
    for (std::size_t i = 0; i < loop.size(); ++i) add(loop[i], loop[(i + 1) % loop.size()]);
  }
  if (sides_.empty()) {
    for (const Segment& wall : room.walls) add(wall.a, wall.b);
  }
  measure();
}

void Floor::add(Vec2 a, Vec2 b) {
  if (is_finite(a) && is_finite(b)) sides_.push_back({a, b});
}

void Floor::measure() noexcept {
  if (sides_.empty()) return;
  const Vec2 along = sides_.front().direction();
  frame_ = {sides_.front().a, std::atan2(along.y, along.x)};
  for (const Segment& side : sides_) {
    for (const Vec2 p : {frame_.inverse_transform(side.a), frame_.inverse_transform(side.b)}) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }
}

bool Floor::contains(Vec2 point) const noexcept {
  bool inside = false;
  for (const Segment& side : sides_) {
    if ((side.a.y > point.y) == (side.b.y > point.y)) continue;
    const double x = side.a.x + (point.y - side.a.y) / (side.b.y - side.a.y) * (side.b.x - side.a.x);
    if (x > point.x) inside = !inside;
  }
  return inside;
}

}  // namespace echoway::thesis
