#include "echoway/import/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "echoway/units.hpp"

namespace echoway::import {
namespace {

// Length of the geodesic between two points by Vincenty's inverse formula (T. Vincenty, "Direct and inverse solutions
// of geodesics on the ellipsoid", Survey Review 23, 1975): no formula in common with the tangent plane.
double vincenty(LonLat p, LonLat q) {
  constexpr double a = 6378137.0, f = 1.0 / 298.257223563, b = a * (1.0 - f);
  const double u1 = std::atan((1.0 - f) * std::tan(degrees(p.lat))),
               u2 = std::atan((1.0 - f) * std::tan(degrees(q.lat)));
  const double l = degrees(std::remainder(q.lon - p.lon, 360.0));
  const double su1 = std::sin(u1), cu1 = std::cos(u1), su2 = std::sin(u2), cu2 = std::cos(u2);
  double lambda = l, sigma = 0.0, sin_sigma = 0.0, cos_sigma = 1.0, cos2_alpha = 0.0, cos_2m = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double x = cu2 * std::sin(lambda), y = cu1 * su2 - su1 * cu2 * std::cos(lambda);
    sin_sigma = std::hypot(x, y);
    if (sin_sigma == 0.0) return 0.0;
    cos_sigma = su1 * su2 + cu1 * cu2 * std::cos(lambda);
    sigma = std::atan2(sin_sigma, cos_sigma);
    const double sin_alpha = cu1 * cu2 * std::sin(lambda) / sin_sigma;
    cos2_alpha = 1.0 - sin_alpha * sin_alpha;
    cos_2m = cos2_alpha > 0.0 ? cos_sigma - 2.0 * su1 * su2 / cos2_alpha : 0.0;
    const double c = f / 16.0 * cos2_alpha * (4.0 + f * (4.0 - 3.0 * cos2_alpha));
    const double before = lambda;
    lambda = l + (1.0 - c) * f * sin_alpha *
                     (sigma + c * sin_sigma * (cos_2m + c * cos_sigma * (2.0 * cos_2m * cos_2m - 1.0)));
    if (std::abs(lambda - before) < 1e-15) break;
  }
  const double k = cos2_alpha * (a * a - b * b) / (b * b);
  const double aa = 1.0 + k / 16384.0 * (4096.0 + k * (-768.0 + k * (320.0 - 175.0 * k)));
  const double bb = k / 1024.0 * (256.0 + k * (-128.0 + k * (74.0 - 47.0 * k)));
  const double d = bb * sin_sigma *
                   (cos_2m + bb / 4.0 * (cos_sigma * (2.0 * cos_2m * cos_2m - 1.0) -
                                         bb / 6.0 * cos_2m * (4.0 * sin_sigma * sin_sigma - 3.0) *
                                             (4.0 * cos_2m * cos_2m - 3.0)));
  return b * aa * (sigma - d);
}

// The formula above is right: a quarter of the meridian of WGS 84 is 10 001 965.729 m, and along the equator a degree
// is a pi / 180.
TEST(Projection, TheIndependentFormulaKnowsTheEllipsoid) {
  EXPECT_NEAR(vincenty({0.0, 0.0}, {0.0, 90.0}), 10001965.729, 0.001);
  EXPECT_NEAR(vincenty({10.0, 0.0}, {11.0, 0.0}), 6378137.0 * kPi / 180.0, 0.001);
}

// 500 m in every direction, from the equator to the far north: distances true to a tenth of a millimetre, both from the
// origin and between the points.
TEST(Projection, DistancesAreTrueOverHalfAKilometre) {
  for (const double lat : {-89.0, -45.0, 0.0, 56.46, 75.0}) {
    for (const double lon : {-2.978, 0.0, 179.999}) {
      const LocalProjection projection({lon, lat});
      const double north = 500.0 / 111000.0, east = north / std::cos(degrees(lat));
      LonLat before{lon, lat};
      for (int i = 0; i < 12; ++i) {
        const double a = degrees(30.0 * i);
        const LonLat p{lon + 0.99 * east * std::cos(a), lat + 0.99 * north * std::sin(a)};
        const double true_from_origin = vincenty({lon, lat}, p);
        EXPECT_NEAR(norm(projection.to_metres(p)), true_from_origin, 1e-4) << lat << " " << lon << " " << i;
        EXPECT_NEAR(distance(projection.to_metres(p), projection.to_metres(before)), vincenty(p, before), 1e-4);
        before = p;
      }
    }
  }
}

TEST(Projection, EastIsXAndNorthIsY) {
  const LocalProjection projection({8.5, 47.4});
  const Vec2 east = projection.to_metres({8.501, 47.4});
  const Vec2 north = projection.to_metres({8.5, 47.401});
  EXPECT_GT(east.x, 75.0);
  EXPECT_NEAR(east.y, 0.0, 0.01);
  EXPECT_GT(north.y, 111.0);
  EXPECT_NEAR(north.x, 0.0, 1e-6);
}

TEST(Projection, ABuildingOnTheAntimeridianStaysInOnePiece) {
  const LocalProjection projection({180.0, -16.8});
  EXPECT_LT(distance(projection.to_metres({179.9999, -16.8}), projection.to_metres({-179.9999, -16.8})), 25.0);
}

}  // namespace
}  // namespace echoway::import
