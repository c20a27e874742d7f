#include "echoway/import/projection.hpp"

#include <cmath>

#include "echoway/units.hpp"

namespace echoway::import {
namespace {

constexpr double kSemiMajor = 6378137.0;                  // metres, WGS 84
constexpr double kFlattening = 1.0 / 298.257223563;       // WGS 84
constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);

}  // namespace

LocalProjection::LocalProjection(LonLat origin)
    : origin_(origin),
      centre_(to_cartesian(origin)),
      sin_lon_(std::sin(degrees(origin.lon))),
      cos_lon_(std::cos(degrees(origin.lon))),
      sin_lat_(std::sin(degrees(origin.lat))),
      cos_lat_(std::cos(degrees(origin.lat))) {}

LocalProjection::Cartesian LocalProjection::to_cartesian(LonLat p) noexcept {
  const double sin_lat = std::sin(degrees(p.lat));
  const double cos_lat = std::cos(degrees(p.lat));
  const double normal = kSemiMajor / std::sqrt(1.0 - kEccentricity2 * sin_lat * sin_lat);
  return {normal * cos_lat * std::cos(degrees(p.lon)), normal * cos_lat * std::sin(degrees(p.lon)),
          normal * (1.0 - kEccentricity2) * sin_lat};
}

Vec2 LocalProjection::to_metres(LonLat p) const noexcept {
  const Cartesian c = to_cartesian(p);
  const double dx = c.x - centre_.x, dy = c.y - centre_.y, dz = c.z - centre_.z;
  return {-sin_lon_ * dx + cos_lon_ * dy, -sin_lat_ * cos_lon_ * dx - sin_lat_ * sin_lon_ * dy + cos_lat_ * dz};
}

}  // namespace echoway::import
