#pragma once

#include <geos_c.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "echoway/geometry/vec2.hpp"

/// A thin, owning C++ face of the GEOS C API, which is the API that GEOS keeps stable. All overlays run on a grid of
/// kGrid, so that they neither fail on nearly touching edges nor leave slivers of rounding.
namespace echoway::import::geos {

/// Coordinates are metres on this grid.
inline constexpr double kGrid = 1e-4;

/// What GEOS could not do; the importer's facade turns it into an Error.
struct GeosError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Polygon2 {
  std::vector<Vec2> outer;  ///< Open ring: the last point differs from the first.
  std::vector<std::vector<Vec2>> holes;
};

class Shape {
 public:
  Shape();                                  ///< Empty.
  explicit Shape(GEOSGeometry* owned);      ///< Takes ownership; throws GeosError when null.
  Shape(const Shape& other);
  Shape& operator=(const Shape& other);
  Shape(Shape&&) noexcept = default;
  Shape& operator=(Shape&& other) noexcept;

  [[nodiscard]] const GEOSGeometry* get() const noexcept { return geometry_.get(); }
  /// The same with an index that finds in O(log n) whether a point lies in it; made when first asked for.
  [[nodiscard]] const GEOSPreparedGeometry* indexed() const;
  [[nodiscard]] bool empty() const;
  [[nodiscard]] double area() const;
  [[nodiscard]] double length() const;

 private:
  struct Deleter {
    void operator()(GEOSGeometry* g) const noexcept;
    void operator()(const GEOSPreparedGeometry* g) const noexcept;
  };
  std::unique_ptr<GEOSGeometry, Deleter> geometry_;
  mutable std::unique_ptr<const GEOSPreparedGeometry, Deleter> indexed_;  // refers to `geometry_`
};

[[nodiscard]] Shape point(Vec2 p);
[[nodiscard]] Shape line(const std::vector<Vec2>& path);
/// The valid area of a polygon: rings that cross themselves are split, and of holes only what lies in the outline is
/// taken out, so that the result is always safe to use.
[[nodiscard]] Shape area_of(const Polygon2& polygon);
/// True when the rings as given bound a valid polygon.
[[nodiscard]] bool is_valid(const Polygon2& polygon);

[[nodiscard]] Shape unite(const std::vector<Shape>& shapes);
[[nodiscard]] Shape difference(const Shape& a, const Shape& b);
[[nodiscard]] Shape intersection(const Shape& a, const Shape& b);
[[nodiscard]] bool intersects(const Shape& a, const Shape& b);
[[nodiscard]] double distance(const Shape& a, const Shape& b);
[[nodiscard]] double distance(const Shape& a, Vec2 p);
[[nodiscard]] bool contains(const Shape& area, Vec2 p);
[[nodiscard]] Vec2 nearest_on(const Shape& shape, Vec2 p);
/// Grown (or shrunk, for negative `by`) with square corners, so that growing and shrinking again keeps right angles.
[[nodiscard]] Shape grow(const Shape& area, double by);
/// A line given a width: flat ends, square corners.
[[nodiscard]] Shape thicken(const std::vector<Vec2>& path, double width);
[[nodiscard]] Shape boundary(const Shape& area);
/// Vertices thinned out: no edge moves by more than `tolerance`, holes and shells neither meet nor vanish.
[[nodiscard]] Shape simplify(const Shape& area, double tolerance);
[[nodiscard]] Shape fill_holes(const Shape& area);

/// The connected areas of a shape; lines and points in it are dropped. In a stable order.
[[nodiscard]] std::vector<Shape> areas(const Shape& shape);
/// REQUIRES: one area.
[[nodiscard]] Polygon2 to_polygon(const Shape& area);
/// REQUIRES: lines.
[[nodiscard]] std::vector<std::vector<Vec2>> to_paths(const Shape& lines);

struct Circle {
  Vec2 centre;
  double radius = 0.0;
};
/// The largest circle that fits, to 2 cm: where a name stands best, and how wide a space is.
[[nodiscard]] Circle inscribed_circle(const Shape& area);

/// `p`, or the nearest point where a person can stand: on the floor and, where it is wide enough, 0.4 m from its walls.
[[nodiscard]] Vec2 standing_point(const Shape& floor, Vec2 p);

struct Bounds {
  Vec2 low, high;
  [[nodiscard]] bool contain(Vec2 p) const noexcept {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }
};
[[nodiscard]] Bounds bounds(const Shape& shape);

struct Box {
  Vec2 centre;
  Vec2 along;  ///< Unit vector of the longer side.
  double length = 0.0;
  double width = 0.0;
};
/// Smallest rectangle of any orientation around a shape.
[[nodiscard]] Box oriented_box(const Shape& shape);
[[nodiscard]] Shape rectangle(Vec2 centre, Vec2 along, double half_length, double back, double front);

}  // namespace echoway::import::geos
