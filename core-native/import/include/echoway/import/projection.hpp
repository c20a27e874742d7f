#pragma once

#include "echoway/geometry/vec2.hpp"

namespace echoway::import {

/// Geographic position on the WGS 84 ellipsoid, degrees.
struct LonLat {
  double lon = 0.0;
  double lat = 0.0;

  friend constexpr bool operator==(const LonLat&, const LonLat&) = default;
};

/// Longitude and latitude to metres east (x) and north (y) of an origin: the local tangent plane of the WGS 84
/// ellipsoid (Hofmann-Wellenhof, Lichtenegger, Wasle, "GNSS", section 8.2.2: geodetic to Cartesian, then rotated into
/// east, north, up at the origin).
///
/// Guarantees: distances from the origin differ from the geodesic by less than d^3 / (6 R^2), one micrometre at 500 m;
/// distances between any two points within 500 m of the origin by less than 10 micrometres.
class LocalProjection {
 public:
  /// REQUIRES: both finite, |lat| < 90.
  explicit LocalProjection(LonLat origin);

  [[nodiscard]] Vec2 to_metres(LonLat p) const noexcept;
  [[nodiscard]] LonLat origin() const noexcept { return origin_; }

 private:
  struct Cartesian {
    double x, y, z;
  };
  static Cartesian to_cartesian(LonLat p) noexcept;

  LonLat origin_;
  Cartesian centre_;
  double sin_lon_, cos_lon_, sin_lat_, cos_lat_;
};

}  // namespace echoway::import
