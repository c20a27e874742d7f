#include "echoway/routing/segment_tree.hpp"

#include <algorithm>
#include <cmath>

namespace echoway {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec2 least(Vec2 a, Vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
Vec2 most(Vec2 a, Vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

double box_distance(Vec2 low, Vec2 high, Vec2 p) {
  const double dx = std::max({low.x - p.x, 0.0, p.x - high.x});
  const double dy = std::max({low.y - p.y, 0.0, p.y - high.y});
  return hypotenuse(dx, dy);
}

/// Entry distance of a ray into a box (slab test); infinity when it misses.
double box_entry(Vec2 low, Vec2 high, Vec2 origin, Vec2 unit) {
  double enter = 0.0;
  double leave = kInfinity;
  const double o[2] = {origin.x, origin.y};
  const double u[2] = {unit.x, unit.y};
  const double l[2] = {low.x, low.y};
  const double h[2] = {high.x, high.y};
  for (int k = 0; k < 2; ++k) {
    if (u[k] == 0.0) {
      if (o[k] < l[k] || o[k] > h[k]) return kInfinity;
      continue;
    }
    const double t0 = (l[k] - o[k]) / u[k];
    const double t1 = (h[k] - o[k]) / u[k];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave ? enter : kInfinity;
}

}  // namespace

bool intersects(const Segment& s, const Segment& t) noexcept {
  const Vec2 u = s.direction();
  const Vec2 v = t.direction();
  const double d1 = cross(u, t.a - s.a);
  const double d2 = cross(u, t.b - s.a);
  const double d3 = cross(v, s.a - t.a);
  const double d4 = cross(v, s.b - t.a);
  if (((d1 > 0.0 && d2 < 0.0) || (d1 < 0.0 && d2 > 0.0)) && ((d3 > 0.0 && d4 < 0.0) || (d3 < 0.0 && d4 > 0.0))) {
    return true;
  }
  // Collinear or touching: one end lies on the other segment.
  const auto within = [](const Segment& g, Vec2 p) {
    return dot(p - g.a, p - g.b) <= 0.0;
  };
  return (d1 == 0.0 && within(s, t.a)) || (d2 == 0.0 && within(s, t.b)) || (d3 == 0.0 && within(t, s.a)) ||
         (d4 == 0.0 && within(t, s.b));
}

double segment_distance(const Segment& s, const Segment& t) noexcept {
  if (intersects(s, t)) return 0.0;
  return std::min({distance(s, t.a), distance(s, t.b), distance(t, s.a), distance(t, s.b)});
}

double ray_distance(Vec2 origin, Vec2 unit, const Segment& s) noexcept {
  const Vec2 along = s.direction();
  const double denominator = cross(unit, along);
  if (denominator == 0.0) return kInfinity;
  const Vec2 to = s.a - origin;
  const double t = cross(to, along) / denominator;
  const double k = cross(to, unit) / denominator;
  return t >= 0.0 && k >= 0.0 && k <= 1.0 ? t : kInfinity;
}

SegmentTree::SegmentTree(std::vector<Segment> segments) : segments_(std::move(segments)) {
  std::erase_if(segments_, [](const Segment& s) { return !is_finite(s.a) || !is_finite(s.b); });
  if (segments_.empty()) return;
  nodes_.reserve(segments_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::int32_t>(segments_.size()));
}

void SegmentTree::build(std::int32_t index, std::int32_t first, std::int32_t count) {
  const auto begin = segments_.begin() + first;
  Vec2 low{kInfinity, kInfinity};
  Vec2 high{-kInfinity, -kInfinity};
  for (auto it = begin; it != begin + count; ++it) {
    low = least(low, least(it->a, it->b));
    high = most(high, most(it->a, it->b));
  }
  if (count <= kLeafSize) {
    nodes_[static_cast<std::size_t>(index)] = {low, high, first, count};
    return;
  }
  const bool split_x = high.x - low.x >= high.y - low.y;
  const std::int32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [split_x](const Segment& s, const Segment& t) {
    return split_x ? s.a.x + s.b.x < t.a.x + t.b.x : s.a.y + s.b.y < t.a.y + t.b.y;
  });
  const auto child = static_cast<std::int32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[static_cast<std::size_t>(index)] = {low, high, child, 0};
  build(child, first, half);
  build(child + 1, first + half, count - half);
}

SegmentTree::Nearest SegmentTree::nearest(Vec2 p, double limit) const noexcept {
  Nearest best;
  best.distance = limit;
  std::int32_t stack[kDepth];
  int top = 0;
  if (!nodes_.empty()) stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
    if (box_distance(node.low, node.high, p) >= best.distance) continue;
    if (node.count == 0) {
      const Node& a = nodes_[static_cast<std::size_t>(node.first)];
      const Node& b = nodes_[static_cast<std::size_t>(node.first) + 1];
      const bool a_first = box_distance(a.low, a.high, p) <= box_distance(b.low, b.high, p);
      stack[top++] = a_first ? node.first + 1 : node.first;
      stack[top++] = a_first ? node.first : node.first + 1;
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const Vec2 q = nearest_point(segments_[static_cast<std::size_t>(i)], p);
      const double d = distance(p, q);
      if (d < best.distance) best = {d, q, i};
    }
  }
  return best;
}

double SegmentTree::ray(Vec2 origin, Vec2 unit, double limit) const noexcept {
  double best = limit;
  std::int32_t stack[kDepth];
  int top = 0;
  if (!nodes_.empty()) stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
    if (!(box_entry(node.low, node.high, origin, unit) < best)) continue;
    if (node.count == 0) {
      stack[top++] = node.first;
      stack[top++] = node.first + 1;
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      best = std::min(best, ray_distance(origin, unit, segments_[static_cast<std::size_t>(i)]));
    }
  }
  return best;
}

bool SegmentTree::may_touch(const Node& node, const Segment& s, double radius) noexcept {
  // Separating axes of the inflated box and the segment: x, y and the segment's normal.
  const Vec2 low{node.low.x - radius, node.low.y - radius};
  const Vec2 high{node.high.x + radius, node.high.y + radius};
  if (std::max(s.a.x, s.b.x) < low.x || std::min(s.a.x, s.b.x) > high.x) return false;
  if (std::max(s.a.y, s.b.y) < low.y || std::min(s.a.y, s.b.y) > high.y) return false;
  const Vec2 normal = perpendicular(s.direction());
  const Vec2 centre = 0.5 * (low + high);
  const Vec2 half = 0.5 * (high - low);
  const double reach = std::abs(normal.x) * half.x + std::abs(normal.y) * half.y;
  return std::abs(dot(normal, centre - s.a)) <= reach;
}

}  // namespace echoway
