#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "echoway/geometry/segment.hpp"

namespace echoway {

/// Shortest distance between two segments; 0 when they touch or cross.
[[nodiscard]] double segment_distance(const Segment& s, const Segment& t) noexcept;

/// True when the segments share a point.
[[nodiscard]] bool intersects(const Segment& s, const Segment& t) noexcept;

/// Where along `origin + t * unit`, t >= 0, the ray first meets `s`, metres; infinity when it does not.
[[nodiscard]] double ray_distance(Vec2 origin, Vec2 unit, const Segment& s) noexcept;

/// A bounding-volume hierarchy over segments: nearest, ray and "anything this close?" queries in O(log n) for plans
/// that are not pathological. Immutable after construction; queries allocate nothing.
class SegmentTree {
 public:
  SegmentTree() = default;
  explicit SegmentTree(std::vector<Segment> segments);

  [[nodiscard]] std::span<const Segment> segments() const noexcept { return segments_; }

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Vec2 point{};
    std::int32_t segment = -1;  ///< Index into segments(); -1 when nothing lies within the limit.
  };
  /// The point of any segment nearest to `p`, if nearer than `limit`.
  [[nodiscard]] Nearest nearest(Vec2 p, double limit = std::numeric_limits<double>::infinity()) const noexcept;

  /// Distance along a ray to the first segment, at most `limit`.
  [[nodiscard]] double ray(Vec2 origin, Vec2 unit, double limit) const noexcept;

  /// True when `accept(segment)` holds for every segment whose distance to `s` may be below `radius`.
  template <class Accept>
  [[nodiscard]] bool all_near(const Segment& s, double radius, Accept accept) const {
    std::int32_t stack[kDepth];
    int top = 0;
    if (!nodes_.empty()) stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
      if (!may_touch(node, s, radius)) continue;
      if (node.count == 0) {
        stack[top++] = node.first;
        stack[top++] = node.first + 1;
        continue;
      }
      for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
        if (!accept(segments_[static_cast<std::size_t>(i)])) return false;
      }
    }
    return true;
  }

 private:
  /// A leaf holds segments [first, first + count); an inner node has count 0 and children first and first + 1.
  struct Node {
    Vec2 low{};
    Vec2 high{};
    std::int32_t first = 0;
    std::int32_t count = 0;
  };
  static constexpr int kLeafSize = 4;
  static constexpr int kDepth = 64;  ///< Median splits: more than any count of segments that fits in memory needs.

  void build(std::int32_t node, std::int32_t first, std::int32_t count);
  [[nodiscard]] static bool may_touch(const Node& node, const Segment& s, double radius) noexcept;

  std::vector<Segment> segments_;
  std::vector<Node> nodes_;
};

}  // namespace echoway
