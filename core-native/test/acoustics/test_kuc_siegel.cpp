#include "echoway/acoustics/kuc_siegel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

namespace echoway {
namespace {

Transducer piston(double radius) {
  Transducer transducer;
  transducer.radius_m = radius;
  return transducer;
}

double seconds_of_support(const CellResponse& response) {
  return static_cast<double>(response.mass.size()) * response.period_s;
}

TEST(HalfEllipseCdf, IsTheIntegralOfTheHalfEllipse) {
  // (2/pi) times the integral of sqrt(1 - v^2) from -1 to u, by hand at u = 1/2:
  // 1/2 + (1/2 * sqrt(3)/2 + pi/6)/pi = 1/2 + 0.137832 + 0.166667 = 0.804499.
  EXPECT_DOUBLE_EQ(half_ellipse_cdf(0.0), 0.5);
  EXPECT_NEAR(half_ellipse_cdf(0.5), 0.8044988905, 1e-10);
  EXPECT_DOUBLE_EQ(half_ellipse_cdf(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(half_ellipse_cdf(1.0), 1.0);
  EXPECT_DOUBLE_EQ(half_ellipse_cdf(7.0), 1.0);
}

TEST(HalfEllipsePairCdf, IsTheIntegralOfTheConvolution) {
  // Brute force: the chance that u + v < w, u and v half-ellipse distributed, by the mid-point rule in angle.
  for (const double w : {-1.7, -0.4, 0.0, 1e-3, 0.25, 1.0, 1.6, 1.99}) {
    constexpr int kSteps = 20000;
    double expected = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double t = kPi * (i + 0.5) / kSteps;
      expected += 2.0 / kSteps * std::sin(t) * std::sin(t) * half_ellipse_cdf(w - std::cos(t));
    }
    EXPECT_NEAR(half_ellipse_pair_cdf(w), expected, 1e-9) << w;
  }
}

TEST(ReceiverResponse, HasTheHeightOfTheFormulaAtItsCentre) {
  // R = 19.2 mm, a = 10 degrees: R sin(a)/c = 3.334 mm / 343.2 m/s = 9.714 us; 2 cos(a)/(pi * 9.714 us) = 64,541 per s.
  const CellResponse response = receiver_response(piston(0.0192), 1.0, degrees(10.0), 1e-8);
  const double centre = response.mass[static_cast<std::size_t>(response.half())];
  EXPECT_NEAR(centre / response.period_s, 64541.0, 30.0);
  // Half-way out, u = 1/2, it is lower by sqrt(3)/2.
  const auto half_way = static_cast<std::size_t>(response.half() + std::lround(0.5 * 9.714e-6 / 1e-8));
  EXPECT_NEAR(response.mass[half_way] / centre, std::sqrt(0.75), 1e-3);
}

TEST(ReceiverResponse, IsOneMicrosecondLongAtHalfADegree) {
  // 2 R sin(a)/c = 2 * 0.0192 * sin(0.51 degrees) / 343 = 1.0 us.
  const CellResponse response = receiver_response(piston(0.0192), 1.0, degrees(0.51), 1e-9);
  EXPECT_NEAR(seconds_of_support(response), 1.0e-6, 0.01e-6);
}

TEST(ReceiverResponse, TakesTheWaveToAndBackOnce) {
  // Each factor is centred at z/c, so that the two together are centred at 2z/c, not 4z/c.
  const Transducer transducer;
  const double z = 3.0;
  EXPECT_DOUBLE_EQ(receiver_response(transducer, z, 0.1, 1e-6).centre_s, z / transducer.sound_speed_mps);
  EXPECT_DOUBLE_EQ(transmit_receive_response(transducer, z, 0.1, 1e-6).centre_s, 2.0 * z / transducer.sound_speed_mps);
}

TEST(TransmitReceiveResponse, IsTheReceiverResponseConvolvedWithItself) {
  const CellResponse single = receiver_response(piston(0.0192), 2.0, degrees(8.0), 1e-8);
  const CellResponse pair = transmit_receive_response(piston(0.0192), 2.0, degrees(8.0), 1e-8);
  const auto n = static_cast<std::ptrdiff_t>(single.mass.size());
  for (const std::ptrdiff_t shift : {0, 100, 500, 1000, 1400}) {
    double expected = 0.0;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const std::ptrdiff_t j = 2 * single.half() + shift - i;
      if (j >= 0 && j < n) {
        expected += single.mass[static_cast<std::size_t>(i)] * single.mass[static_cast<std::size_t>(j)];
      }
    }
    EXPECT_NEAR(pair.mass[static_cast<std::size_t>(pair.half() + shift)], expected,
                2e-3 * pair.mass[pair.mass.size() / 2])
        << shift;
  }
}

TEST(TransmitReceiveResponse, TransformsIntoTheDirectivitySquared) {
  // The transform of h_R is cos(a) 2 J1(kR sin a)/(kR sin a); that of the pair its square.
  const Transducer transducer = piston(0.0192);
  for (const double angle : {1.0, 5.0, 9.0, 12.74, 20.0}) {
    const double a = degrees(angle);
    const CellResponse pair = transmit_receive_response(transducer, 1.0, a, 2e-8);
    double transform = 0.0;
    for (std::size_t i = 0; i < pair.mass.size(); ++i) {
      const double t = (static_cast<double>(i) - static_cast<double>(pair.half())) * pair.period_s;
      transform += pair.mass[i] * std::cos(kTwoPi * transducer.frequency_hz * t);
    }
    const double directivity = std::cos(a) * piston_directivity(transducer.wavenumber() * 0.0192 * std::sin(a));
    EXPECT_NEAR(transform, directivity * directivity, 1e-5) << angle;
  }
}

// inclination, radius, distance, period
using Extreme = std::tuple<double, double, double, double>;
class ExtremeResponse : public testing::TestWithParam<Extreme> {};

TEST_P(ExtremeResponse, KeepsItsIntegralSymmetrySignAndCentre) {
  const auto [inclination, radius, distance, period] = GetParam();
  const double c = std::abs(inclination) < kPi / 2.0 ? std::max(0.0, std::cos(inclination)) : 0.0;
  const Transducer transducer = piston(radius);
  const CellResponse one = receiver_response(transducer, distance, inclination, period);
  const CellResponse two = transmit_receive_response(transducer, distance, inclination, period);
  EXPECT_NEAR(one.integral(), c, 1e-12);
  EXPECT_NEAR(two.integral(), c * c, 1e-12);
  EXPECT_NEAR(two.centre_s, 2.0 * one.centre_s, 1e-15 * two.centre_s);
  for (const CellResponse& response : {one, two}) {
    EXPECT_EQ(response.mass.size() % 2, 1U);
    EXPECT_LE(response.mass.size(), kMaxCells);
    EXPECT_GE(response.period_s, period);
    const bool symmetric = std::equal(response.mass.begin(), response.mass.end(), response.mass.rbegin());
    EXPECT_TRUE(symmetric);
    EXPECT_TRUE(std::all_of(response.mass.begin(), response.mass.end(), [](double m) { return m >= 0.0; }));
  }
}

constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

INSTANTIATE_TEST_SUITE_P(Inclinations, ExtremeResponse,
                         testing::Combine(testing::Values(0.0, kDenormal, 1e-12, 1e-9, 1e-6, 1e-3, -0.1,
                                                          0.22236 /* null, 12.74 degrees */, 0.2628, 1.0,
                                                          kPi / 2.0 - 1e-9, kPi / 2.0, kPi / 2.0 + 1e-9, 3.0),
                                          testing::Values(0.0192), testing::Values(1.0),
                                          testing::Values(1e-9, 1e-6, 1e-3)));
INSTANTIATE_TEST_SUITE_P(RadiiAndDistances, ExtremeResponse,
                         testing::Combine(testing::Values(0.1),
                                          testing::Values(0.0, kDenormal, 1e-9, 0.0163, 1e6, 1e300),
                                          testing::Values(0.0, 1e-9, 0.15, 10.67, 1e9),
                                          testing::Values(1e-3)));
INSTANTIATE_TEST_SUITE_P(ManyCells, ExtremeResponse,
                         testing::Combine(testing::Values(0.1), testing::Values(0.0163, 1.0), testing::Values(10.67),
                                          testing::Values(1e-8)));

TEST(ReceiverResponse, LengthensAPeriodThatWouldNeedTooManyCells) {
  const CellResponse response = receiver_response(piston(100.0), 1.0, 1.0, 1e-9);
  EXPECT_GT(response.period_s, 1e-9);
  EXPECT_NEAR(response.integral(), std::cos(1.0), 1e-12);
}

TEST(ReceiverResponse, RefusesWhatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(receiver_response(piston(nan), 1.0, 0.1, 1e-6).mass.empty());
  EXPECT_TRUE(receiver_response(piston(-1.0), 1.0, 0.1, 1e-6).mass.empty());
  EXPECT_TRUE(receiver_response(piston(0.02), -1.0, 0.1, 1e-6).mass.empty());
  EXPECT_TRUE(receiver_response(piston(0.02), 1.0, nan, 1e-6).mass.empty());
  EXPECT_TRUE(transmit_receive_response(piston(0.02), 1.0, 0.1, 0.0).mass.empty());
}

}  // namespace
}  // namespace echoway
