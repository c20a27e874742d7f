#include "echoway/acoustics/detection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace echoway {
namespace {

BeltConfig belt_with_beam(double beam_degrees) {
  BeltConfig belt;
  belt.beam_rad = degrees(beam_degrees);
  return belt;
}

TEST(DetectionTable, LetsAPlaneAnswerWithinTheBeltsBeam) {
  // The gain makes up for spreading until 38 ms, 6.5 m; the beam holds up to there and narrows a little beyond.
  for (const double beam : {5.0, 15.0, 55.0, 90.0}) {
    const DetectionTable table(belt_with_beam(beam));
    for (const double z : {0.2, 1.0, 6.4}) {
      EXPECT_NEAR(to_degrees(table.half_angle(ElementKind::wall, z)), 0.5 * beam, 1e-3 * beam) << beam << ' ' << z;
    }
    EXPECT_LT(table.half_angle(ElementKind::wall, 10.6), table.half_angle(ElementKind::wall, 6.0)) << beam;
    EXPECT_GT(table.half_angle(ElementKind::wall, 10.6), 0.45 * degrees(beam)) << beam;
  }
}

TEST(DetectionTable, TreatsCornersAsWallsAndReflectorsAsTheWholeBeam) {
  const DetectionTable table(belt_with_beam(15.0));
  EXPECT_EQ(table.half_angle(ElementKind::corner, 3.0), table.half_angle(ElementKind::wall, 3.0));
  EXPECT_NEAR(to_degrees(table.half_angle(ElementKind::reflector, 10.0)), 7.5, 1e-9);
}

TEST(DetectionTable, NarrowsTheBeamForEdgesUntilTheyFallSilent) {
  const DetectionTable table(belt_with_beam(15.0));
  double before = table.half_angle(ElementKind::wall, 0.2);
  for (const double z : {0.2, 0.5, 1.0, 2.0, 2.9}) {
    const double now = table.half_angle(ElementKind::edge, z);
    EXPECT_LT(now, before) << z;
    EXPECT_GT(now, 0.0) << z;
    before = now;
  }
  EXPECT_LT(table.half_angle(ElementKind::edge, 3.1), 0.0);
  EXPECT_GT(table.half_angle(ElementKind::edge, 3.1 * 0.9), 0.0);
}

TEST(DetectionTable, AgreesWithTheWaveformAgainstTheThreshold) {
  // The table is the oracle's own answer: just inside the half-angle the echo is found, just outside it is not.
  const DetectionTable table(belt_with_beam(15.0));
  for (const double z : {0.3, 1.0, 2.5, 8.0}) {
    for (const ElementKind kind : {ElementKind::wall, ElementKind::edge}) {
      const double half = table.half_angle(kind, z);
      if (half < 0.0) continue;
      const auto heard = [&](double inclination) {
        const double period = 1.0 / (16.0 * table.transducer().frequency_hz);
        return first_crossing(echo_waveform(table.transducer(), kind, z, inclination, period), table.receiver());
      };
      EXPECT_TRUE(heard(0.96 * half)) << z;
      EXPECT_FALSE(heard(1.04 * half)) << z;
    }
  }
}

TEST(DetectionTable, FindsASmallPistonForAWideBeam) {
  // A 55 degree sensor of the thesis's table 3.2 (40LPT16) is 16.2 mm across at 40 kHz.
  EXPECT_NEAR(DetectionTable(belt_with_beam(55.0)).transducer().radius_m, 0.0081, 0.001);
}

TEST(DetectionTable, StandsAnyBelt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double beam : {0.0, -3.0, 1e-9, 180.0, 720.0, nan}) {
    BeltConfig belt = belt_with_beam(beam);
    belt.max_range_m = beam;  // as bad
    const DetectionTable table(belt, {beam, beam});
    for (const double z : {0.0, 1.0, 1e9}) {
      for (const ElementKind kind : {ElementKind::wall, ElementKind::edge, ElementKind::reflector}) {
        EXPECT_TRUE(std::isfinite(table.half_angle(kind, z)));
        EXPECT_LE(table.half_angle(kind, z), kPi / 2.0);
      }
    }
    EXPECT_LT(table.half_angle(ElementKind::none, 1.0), 0.0);
  }
}

}  // namespace
}  // namespace echoway
