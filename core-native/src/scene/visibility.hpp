#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "echoway/geometry/box.hpp"
#include "echoway/geometry/segment.hpp"

namespace echoway::scene {

/// True when a line across `axis` separates `s` from all `points`.
template <std::size_t N>
[[nodiscard]] bool separated(Vec2 axis, const std::array<Vec2, N>& points, const Segment& s) noexcept {
  double low = dot(axis, points[0]);
  double high = low;
  for (std::size_t i = 1; i < N; ++i) {
    const double v = dot(axis, points[i]);
    low = v < low ? v : low;
    high = v > high ? v : high;
  }
  const double a = dot(axis, s.a);
  const double b = dot(axis, s.b);
  return (a < low && b < low) || (a > high && b > high);
}

/// False only when a line separates `s` from the convex hull of `points`; the axes tried are those of the points' own
/// connections and of `s`, so a true answer may be a near miss. Leaving something out on false is therefore safe.
template <std::size_t N>
[[nodiscard]] bool hull_may_touch(const std::array<Vec2, N>& points, const Segment& s) noexcept {
  if (separated({1.0, 0.0}, points, s) || separated({0.0, 1.0}, points, s)) return false;
  if (separated(perpendicular(s.direction()), points, s)) return false;
  for (std::size_t i = 0; i + 1 < N; ++i) {
    for (std::size_t j = i + 1; j < N; ++j) {
      if (separated(perpendicular(points[j] - points[i]), points, s)) return false;
    }
  }
  return true;
}

/// Bounding box of some points: most of a large room's walls are ruled out by it alone.
struct Bounds : echoway::Box {
  [[nodiscard]] Bounds grown(double by) const noexcept { return {{low - Vec2{by, by}, high + Vec2{by, by}}}; }
  [[nodiscard]] bool misses(const Segment& s) const noexcept {
    // Which of the four it is nobody can predict: all at once cost less than a wrong guess.
    const int left = std::max(s.a.x, s.b.x) < low.x, right = std::min(s.a.x, s.b.x) > high.x;
    const int below = std::max(s.a.y, s.b.y) < low.y, above = std::min(s.a.y, s.b.y) > high.y;
    return (left | right | below | above) != 0;
  }
  [[nodiscard]] bool misses(const Bounds& other) const noexcept {
    return other.high.x < low.x || other.low.x > high.x || other.high.y < low.y || other.low.y > high.y;
  }
};

/// All straight ways from a parallelogram of places to a stretch, or to a point: a convex hull against which many
/// segments are tested. Of the lines that may separate them its own sides are worked out once.
class Hull {
 public:
  /// From an upright box.
  Hull(const std::array<Vec2, 4>& box, const Segment& to) noexcept
      : points_{box[0], box[1], box[2], box[3], to.a, to.b} {
    bound();
    const Vec2 centre = 0.5 * (box[0] + box[2]);
    const bool a_is_right = cross(to.a - centre, to.b - centre) >= 0.0;
    add_side(outermost(a_is_right ? to.b : to.a, 1.0));
    add_side(outermost(a_is_right ? to.a : to.b, -1.0));
    if (to.a != to.b) add_side(a_is_right ? -perpendicular(to.direction()) : perpendicular(to.direction()));
  }

  /// From a parallelogram (a, b; c next to a) to a point.
  Hull(Vec2 a, Vec2 b, Vec2 c, Vec2 to) noexcept : points_{a, b, b + (c - a), c, to, to} {
    bound();
    add_side(outermost(to, 1.0));
    add_side(outermost(to, -1.0));
    for (const Vec2 along : {b - a, c - a}) {
      add_side(perpendicular(along));
      add_side(-perpendicular(along));
    }
  }

  [[nodiscard]] const Bounds& bounds() const noexcept { return bounds_; }

  /// False only when a line separates `s` from the hull; true may be a near miss.
  [[nodiscard]] bool may_touch(const Segment& s) const noexcept {
    if (bounds_.misses(s)) return false;
    for (std::size_t i = 0; i < count_; ++i) {
      if (dot(sides_[i].out, s.a) > sides_[i].reach && dot(sides_[i].out, s.b) > sides_[i].reach) return false;
    }
    return !separated(perpendicular(s.direction()), points_, s);
  }

 private:
  /// Beyond `reach` along `out` there is nothing of the hull.
  struct Side {
    Vec2 out;
    double reach;
  };

  void bound() noexcept {
    for (const Vec2 p : points_) bounds_.include(p);
  }

  /// Away from the outermost way to `to`, on the left (`hand` 1) or on the right (-1).
  [[nodiscard]] Vec2 outermost(Vec2 to, double hand) const noexcept {
    Vec2 from = points_[0];
    for (std::size_t i = 1; i < 4; ++i) {
      if (hand * cross(to - from, points_[i] - from) > 0.0) from = points_[i];
    }
    return hand * perpendicular(to - from);
  }

  void add_side(Vec2 out) noexcept {
    double reach = dot(out, points_[0]);
    for (std::size_t i = 1; i < points_.size(); ++i) reach = std::max(reach, dot(out, points_[i]));
    sides_[count_++] = {out, reach};
  }

  std::array<Vec2, 6> points_;
  Bounds bounds_;
  std::array<Side, 6> sides_{};
  std::size_t count_ = 0;
};

/// True when the open way from `p` to `q` properly crosses `s`.
[[nodiscard]] inline bool blocks(const Segment& s, Vec2 p, Vec2 q) noexcept {
  const Vec2 d = q - p;
  const double a = cross(d, s.a - p);
  const double b = cross(d, s.b - p);
  if ((a > 0.0) == (b > 0.0)) return false;
  const Vec2 e = s.direction();
  const double c = cross(e, p - s.a);
  const double f = cross(e, q - s.a);
  return (c > 0.0) != (f > 0.0);
}

/// What lies beyond a door is heard through the opening; nearer to its centre than this, the belt may already be
/// through.
inline constexpr double kInDoorway = 0.6;

/// Sight to a reflector is followed to this much in front of it, so that what it touches does not hide it.
inline constexpr double kSightClearance = 0.03;

/// A wall's mirror spot needs about half a Fresnel zone of wall (sqrt(lambda z) / 2, 7 cm at 3 m): the echo fades over
/// this much before a wall's end and as much beyond it; over more where headings are on a coarse grid.
inline constexpr double kWallEndSoftness = 0.07;
inline constexpr double kCoarseWallEndSoftness = 0.20;

/// `to`, drawn back towards `from` by kSightClearance (or to the middle of the way if that is nearer).
[[nodiscard]] inline Vec2 in_front_of(Vec2 to, Vec2 from, double way) noexcept {
  const double back = way > 2.0 * kSightClearance ? kSightClearance / way : 0.5;
  return to + back * (from - to);
}

}  // namespace echoway::scene
