#include "echoway/acoustics/transducer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace echoway {
namespace {

TEST(Transducer, HasTheWavelengthAndWavenumberOfItsTone) {
  // 343.2 m/s / 49.4 kHz = 6.95 mm; 2 pi / 6.95 mm = 904 per metre (the usual 905 takes c = 343).
  const Transducer polaroid;
  EXPECT_NEAR(polaroid.wavelength_m(), 6.948e-3, 2e-6);
  EXPECT_NEAR(polaroid.wavenumber(), 904.4, 0.5);
}

TEST(PistonDirectivity, IsOneHeadOnAndHasItsFirstNullAt3Point83) {
  EXPECT_DOUBLE_EQ(piston_directivity(0.0), 1.0);
  // J1 has its first positive zero at 3.83170597020751 (Abramowitz and Stegun, table 9.5).
  EXPECT_NEAR(piston_directivity(3.83170597020751), 0.0, 1e-14);
}

TEST(PistonDirectivity, AgreesWithTabulatedBesselValues) {
  // J1(1) = 0.4400505857, J1(2) = 0.5767248078, J1(5) = -0.3275791376, J1(10) = 0.0434727462 (A&S table 9.1).
  EXPECT_NEAR(piston_directivity(1.0), 2.0 * 0.4400505857, 2e-10);
  EXPECT_NEAR(piston_directivity(2.0), 0.5767248078, 2e-10);
  EXPECT_NEAR(piston_directivity(5.0), -2.0 / 5.0 * 0.3275791376, 2e-10);
  EXPECT_NEAR(piston_directivity(10.0), 0.2 * 0.0434727462, 2e-10);
}

TEST(PistonDirectivity, IsFlatAroundTheRemovableSingularity) {
  // 2 J1(x)/x = 1 - x^2/8 + ...
  for (const double x : {5e-324, 1e-300, 1e-12, 1e-8, 1e-5, 1e-3}) {
    EXPECT_NEAR(piston_directivity(x), 1.0 - x * x / 8.0, 1e-14) << x;
    EXPECT_EQ(piston_directivity(-x), piston_directivity(x)) << x;
  }
}

TEST(PistonDirectivity, JoinsItsBranchesWithoutAStep) {
  for (const double seam : {2.0, 60.0}) {
    const double below = piston_directivity(std::nextafter(seam, 0.0));
    EXPECT_NEAR(below, piston_directivity(seam), 1e-12) << seam;
  }
}

TEST(PistonDirectivity, HasTheNullsOfTheTwoPolaroidFaces) {
  // sin(a) = 3.8317 / (k R) with k = 905 per metre: 12.7 degrees for R = 19.2 mm, 15.1 degrees for 16.3 mm.
  EXPECT_NEAR(to_degrees(std::asin(3.8317 / (905.0 * 0.0192))), 12.7, 0.05);
  EXPECT_NEAR(piston_directivity(905.0 * 0.0192 * std::sin(degrees(12.74))), 0.0, 2e-3);
  EXPECT_NEAR(piston_directivity(905.0 * 0.0163 * std::sin(degrees(15.05))), 0.0, 2e-3);
}

TEST(PistonDirectivity, StaysBoundedAndFinite) {
  for (const double x : {1e3, 1e9, 1e300, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_LE(std::abs(piston_directivity(x)), 1e-4) << x;
  }
}

}  // namespace
}  // namespace echoway
