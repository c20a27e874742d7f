#pragma once

#include <algorithm>
#include <cmath>

namespace echoway {

/// A point or a displacement in a plane, metres. x to the right, y up the plan.
struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) noexcept { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) noexcept { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) noexcept { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 v) noexcept { return {s * v.x, s * v.y}; }
  friend constexpr Vec2 operator*(Vec2 v, double s) noexcept { return s * v; }
};

[[nodiscard]] constexpr double dot(Vec2 a, Vec2 b) noexcept { return a.x * b.x + a.y * b.y; }

/// z component of a x b: positive when b lies counter-clockwise of a.
[[nodiscard]] constexpr double cross(Vec2 a, Vec2 b) noexcept { return a.x * b.y - a.y * b.x; }

[[nodiscard]] constexpr double squared_norm(Vec2 v) noexcept { return dot(v, v); }

/// sqrt(x^2 + y^2) without overflow or loss for any finite x and y. In place of std::hypot(), whose last bit differs
/// from one processor's libm to the next; a root and a division do not.
[[nodiscard]] inline double hypotenuse(double x, double y) noexcept {
  const double squared = x * x + y * y;
  if (squared > 1e-280 && squared < 1e300) return std::sqrt(squared);
  const double longer = std::max(std::fabs(x), std::fabs(y));
  if (longer == 0.0 || std::isinf(longer)) return longer;
  return longer * std::sqrt((x / longer) * (x / longer) + (y / longer) * (y / longer));
}

[[nodiscard]] inline double norm(Vec2 v) noexcept { return hypotenuse(v.x, v.y); }
[[nodiscard]] inline double distance(Vec2 a, Vec2 b) noexcept { return norm(b - a); }

/// `v` turned by 90 degrees counter-clockwise.
[[nodiscard]] constexpr Vec2 perpendicular(Vec2 v) noexcept { return {-v.y, v.x}; }

[[nodiscard]] inline Vec2 unit_from_angle(double radians) noexcept { return {std::cos(radians), std::sin(radians)}; }

/// `v` turned counter-clockwise by the angle of `unit`: +x comes to lie on `unit`.
[[nodiscard]] constexpr Vec2 rotated(Vec2 v, Vec2 unit) noexcept {
  return {unit.x * v.x - unit.y * v.y, unit.y * v.x + unit.x * v.y};
}

[[nodiscard]] inline bool is_finite(Vec2 v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y); }

}  // namespace echoway
