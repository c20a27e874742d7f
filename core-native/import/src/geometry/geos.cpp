#include "geometry/geos.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace echoway::import::geos {
namespace {

constexpr double kMitreLimit = 5.0;
constexpr int kQuadrantSegments = 8;

// One context a thread: GEOS keeps its last error message in it.
class Context {
 public:
  Context() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(handle_, [](const char* text, void* self) {
      static_cast<Context*>(self)->message_ = text;
    }, this);
  }
  ~Context() { GEOS_finish_r(handle_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  [[nodiscard]] GEOSContextHandle_t handle() const noexcept { return handle_; }
  [[noreturn]] void fail(const char* what) const {
    throw GeosError(std::string("planar geometry failed: ") + what + (message_.empty() ? "" : ": " + message_));
  }

 private:
  GEOSContextHandle_t handle_;
  std::string message_;
};

Context& context() {
  thread_local Context instance;
  return instance;
}

GEOSContextHandle_t h() { return context().handle(); }

GEOSCoordSequence* sequence(const std::vector<Vec2>& points, bool close) {
  const auto n = static_cast<unsigned>(points.size() + (close ? 1 : 0));
  GEOSCoordSequence* s = GEOSCoordSeq_create_r(h(), n, 2);
  if (s == nullptr) context().fail("coordinates");
  for (unsigned i = 0; i < n; ++i) {
    const Vec2 p = points[i % points.size()];
    GEOSCoordSeq_setXY_r(h(), s, i, p.x, p.y);
  }
  return s;
}

GEOSGeometry* ring(const std::vector<Vec2>& points) {
  GEOSGeometry* r = GEOSGeom_createLinearRing_r(h(), sequence(points, true));
  if (r == nullptr) context().fail("ring");
  return r;
}

std::vector<Vec2> points_of(const GEOSGeometry* line) {
  const GEOSCoordSequence* s = GEOSGeom_getCoordSeq_r(h(), line);
  unsigned n = 0;
  GEOSCoordSeq_getSize_r(h(), s, &n);
  std::vector<Vec2> points(n);
  for (unsigned i = 0; i < n; ++i) GEOSCoordSeq_getXY_r(h(), s, i, &points[i].x, &points[i].y);
  return points;
}

std::vector<Vec2> ring_points(const GEOSGeometry* r) {
  std::vector<Vec2> points = points_of(r);
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

Shape raw_polygon(const Polygon2& p) {
  std::vector<GEOSGeometry*> holes;
  for (const auto& hole : p.holes) holes.push_back(ring(hole));
  return Shape(GEOSGeom_createPolygon_r(h(), ring(p.outer), holes.data(), static_cast<unsigned>(holes.size())));
}

void collect_areas(const GEOSGeometry* g, std::vector<Shape>& into) {
  const int type = GEOSGeomTypeId_r(h(), g);
  if (type == GEOS_POLYGON) {
    if (GEOSisEmpty_r(h(), g) == 0) into.emplace_back(GEOSGeom_clone_r(h(), g));
    return;
  }
  if (type != GEOS_MULTIPOLYGON && type != GEOS_GEOMETRYCOLLECTION) return;
  const int n = GEOSGetNumGeometries_r(h(), g);
  for (int i = 0; i < n; ++i) collect_areas(GEOSGetGeometryN_r(h(), g, i), into);
}

void collect_paths(const GEOSGeometry* g, std::vector<std::vector<Vec2>>& into) {
  const int type = GEOSGeomTypeId_r(h(), g);
  if (type == GEOS_LINESTRING || type == GEOS_LINEARRING) {
    if (GEOSisEmpty_r(h(), g) == 0) into.push_back(points_of(g));
    return;
  }
  if (type != GEOS_MULTILINESTRING && type != GEOS_GEOMETRYCOLLECTION) return;
  const int n = GEOSGetNumGeometries_r(h(), g);
  for (int i = 0; i < n; ++i) collect_paths(GEOSGetGeometryN_r(h(), g, i), into);
}

Shape only_areas(const Shape& shape) { return unite(areas(shape)); }

Shape made_valid(const std::vector<Vec2>& outline) {
  return only_areas(Shape(GEOSMakeValid_r(h(), raw_polygon({outline, {}}).get())));
}

// Rings start where the direction changes most, so that simplification can thin out every other vertex.
void start_at_sharpest(std::vector<Vec2>& r) {
  std::size_t best = 0;
  double sharpest = -1.0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Vec2 before = r[i] - r[(i + r.size() - 1) % r.size()];
    const Vec2 after = r[(i + 1) % r.size()] - r[i];
    const double turn = std::abs(cross(before, after)) / (norm(before) * norm(after));
    if (turn > sharpest + 1e-9) {
      sharpest = turn;
      best = i;
    }
  }
  std::rotate(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(best), r.end());
}

}  // namespace

void Shape::Deleter::operator()(GEOSGeometry* g) const noexcept { GEOSGeom_destroy_r(h(), g); }
void Shape::Deleter::operator()(const GEOSPreparedGeometry* g) const noexcept { GEOSPreparedGeom_destroy_r(h(), g); }
Shape::Shape() : geometry_(GEOSGeom_createEmptyPolygon_r(h())) {}
Shape::Shape(GEOSGeometry* owned) : geometry_(owned) {
  if (owned == nullptr) context().fail("overlay");
}
Shape::Shape(const Shape& other) : geometry_(GEOSGeom_clone_r(h(), other.get())) {}
Shape& Shape::operator=(const Shape& other) {
  if (this != &other) *this = Shape(other);
  return *this;
}
Shape& Shape::operator=(Shape&& other) noexcept {
  indexed_ = std::move(other.indexed_);  // before what it refers to
  geometry_ = std::move(other.geometry_);
  return *this;
}
const GEOSPreparedGeometry* Shape::indexed() const {
  if (indexed_ == nullptr) indexed_.reset(GEOSPrepare_r(h(), get()));
  if (indexed_ == nullptr) context().fail("index");
  return indexed_.get();
}
bool Shape::empty() const { return GEOSisEmpty_r(h(), get()) == 1; }
double Shape::area() const {
  double a = 0.0;
  if (GEOSArea_r(h(), get(), &a) == 0) context().fail("area");
  return a;
}
double Shape::length() const {
  double l = 0.0;
  if (GEOSLength_r(h(), get(), &l) == 0) context().fail("length");
  return l;
}

Shape point(Vec2 p) { return Shape(GEOSGeom_createPointFromXY_r(h(), p.x, p.y)); }
Shape line(const std::vector<Vec2>& path) { return Shape(GEOSGeom_createLineString_r(h(), sequence(path, false))); }

Shape area_of(const Polygon2& polygon) {
  const Shape raw = raw_polygon(polygon);
  if (GEOSisValid_r(h(), raw.get()) == 1) return Shape(GEOSGeom_setPrecision_r(h(), raw.get(), kGrid, 0));
  Shape area = made_valid(polygon.outer);
  for (const auto& hole : polygon.holes) area = difference(area, made_valid(hole));
  return only_areas(area);
}

bool is_valid(const Polygon2& polygon) { return GEOSisValid_r(h(), raw_polygon(polygon).get()) == 1; }

Shape unite(const std::vector<Shape>& shapes) {
  if (shapes.empty()) return {};
  std::vector<GEOSGeometry*> parts;
  for (const Shape& s : shapes) parts.push_back(GEOSGeom_clone_r(h(), s.get()));
  const Shape all(GEOSGeom_createCollection_r(h(), GEOS_GEOMETRYCOLLECTION, parts.data(),
                                              static_cast<unsigned>(parts.size())));
  return Shape(GEOSUnaryUnionPrec_r(h(), all.get(), kGrid));
}

Shape difference(const Shape& a, const Shape& b) { return Shape(GEOSDifferencePrec_r(h(), a.get(), b.get(), kGrid)); }
Shape intersection(const Shape& a, const Shape& b) {
  return Shape(GEOSIntersectionPrec_r(h(), a.get(), b.get(), kGrid));
}
bool intersects(const Shape& a, const Shape& b) { return GEOSIntersects_r(h(), a.get(), b.get()) == 1; }
double distance(const Shape& a, const Shape& b) {
  double d = 0.0;
  if (GEOSDistance_r(h(), a.get(), b.get(), &d) == 0) context().fail("distance");
  return d;
}
double distance(const Shape& a, Vec2 p) { return distance(a, point(p)); }
bool contains(const Shape& area, Vec2 p) { return GEOSPreparedContains_r(h(), area.indexed(), point(p).get()) == 1; }

Vec2 nearest_on(const Shape& shape, Vec2 p) {
  GEOSCoordSequence* pair = GEOSNearestPoints_r(h(), shape.get(), point(p).get());
  if (pair == nullptr) context().fail("nearest point");
  Vec2 found;
  GEOSCoordSeq_getXY_r(h(), pair, 0, &found.x, &found.y);
  GEOSCoordSeq_destroy_r(h(), pair);
  return found;
}

Shape grow(const Shape& area, double by) {
  return Shape(GEOSBufferWithStyle_r(h(), area.get(), by, kQuadrantSegments, GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE,
                                     kMitreLimit));
}

Shape thicken(const std::vector<Vec2>& path, double width) {
  return Shape(GEOSBufferWithStyle_r(h(), line(path).get(), width / 2.0, kQuadrantSegments, GEOSBUF_CAP_FLAT,
                                     GEOSBUF_JOIN_MITRE, kMitreLimit));
}

Shape boundary(const Shape& area) { return Shape(GEOSBoundary_r(h(), area.get())); }

Shape simplify(const Shape& area, double tolerance) {
  std::vector<Shape> parts;
  for (const Shape& part : areas(area)) {
    Polygon2 polygon = to_polygon(part);
    start_at_sharpest(polygon.outer);
    for (auto& hole : polygon.holes) start_at_sharpest(hole);
    parts.emplace_back(GEOSTopologyPreserveSimplify_r(h(), raw_polygon(polygon).get(), tolerance));
  }
  return unite(parts);
}

Shape fill_holes(const Shape& area) {
  std::vector<Shape> parts;
  for (const Shape& part : areas(area)) parts.push_back(area_of({to_polygon(part).outer, {}}));
  return unite(parts);
}

std::vector<Shape> areas(const Shape& shape) {
  std::vector<Shape> found;
  collect_areas(shape.get(), found);
  return found;
}

Polygon2 to_polygon(const Shape& area) {
  Polygon2 polygon;
  const GEOSGeometry* g = area.get();
  if (GEOSGeomTypeId_r(h(), g) != GEOS_POLYGON) g = GEOSGetGeometryN_r(h(), g, 0);
  polygon.outer = ring_points(GEOSGetExteriorRing_r(h(), g));
  const int n = GEOSGetNumInteriorRings_r(h(), g);
  for (int i = 0; i < n; ++i) polygon.holes.push_back(ring_points(GEOSGetInteriorRingN_r(h(), g, i)));
  return polygon;
}

std::vector<std::vector<Vec2>> to_paths(const Shape& lines) {
  std::vector<std::vector<Vec2>> paths;
  collect_paths(lines.get(), paths);
  return paths;
}

Circle inscribed_circle(const Shape& area) {
  constexpr double kTolerance = 0.02;
  const Shape radius(GEOSMaximumInscribedCircle_r(h(), area.get(), kTolerance));
  const std::vector<Vec2> ends = points_of(radius.get());
  return {ends.front(), echoway::distance(ends.front(), ends.back())};
}

Vec2 standing_point(const Shape& floor, Vec2 p) {
  constexpr double kFromWall = 0.4;  // metres
  const Shape clear = grow(floor, -kFromWall);
  return nearest_on(clear.empty() ? floor : clear, p);
}

Bounds bounds(const Shape& shape) {
  Bounds b;
  if (GEOSGeom_getExtent_r(h(), shape.get(), &b.low.x, &b.low.y, &b.high.x, &b.high.y) == 0) context().fail("extent");
  return b;
}

Box oriented_box(const Shape& shape) {
  const Shape rotated(GEOSMinimumRotatedRectangle_r(h(), shape.get()));
  if (GEOSGeomTypeId_r(h(), rotated.get()) != GEOS_POLYGON) context().fail("a shape without area");
  const std::vector<Vec2> corner = to_polygon(rotated).outer;
  const Vec2 first = corner[1] - corner[0], second = corner[2] - corner[1];
  const bool first_longer = norm(first) >= norm(second);
  const Vec2 longer = first_longer ? first : second;
  const double length = norm(longer);
  return {0.5 * (corner[0] + corner[2]), (1.0 / length) * longer, length, norm(first_longer ? second : first)};
}

Shape rectangle(Vec2 centre, Vec2 along, double half_length, double back, double front) {
  const Vec2 n = perpendicular(along);
  return area_of({{centre - half_length * along - back * n, centre + half_length * along - back * n,
                   centre + half_length * along + front * n, centre - half_length * along + front * n},
                  {}});
}

}  // namespace echoway::import::geos
