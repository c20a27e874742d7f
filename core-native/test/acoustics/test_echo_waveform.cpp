#include "echoway/acoustics/echo_waveform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace echoway {
namespace {

constexpr double kFine = 5e-7;  // s; 40 samples a cycle

double decibels(double ratio) { return 20.0 * std::log10(ratio); }

TEST(EdgeDiffraction, Is37DecibelsAtOneMetreAnd42AtThree) {
  // lambda = 6.95 mm: 2 pi sqrt(1 / 0.00695) = 75.4, 37.5 dB; 2 pi sqrt(3 / 0.00695) = 130.6, 42.3 dB.
  const double lambda = Transducer{}.wavelength_m();
  EXPECT_NEAR(1.0 / edge_diffraction_factor(1.0, lambda), 75.4, 0.1);
  EXPECT_NEAR(decibels(edge_diffraction_factor(1.0, lambda)), -37.5, 0.1);
  EXPECT_NEAR(decibels(edge_diffraction_factor(3.0, lambda)), -42.3, 0.1);
}

TEST(EdgeDiffraction, NeverBeatsAReflection) {
  for (const double z : {0.0, 1e-9, 1e-5, 1e-4}) EXPECT_LE(edge_diffraction_factor(z, 0.007), 1.0) << z;
}

TEST(ReflectionAmplitude, IsTheSameForAWallAndACornerAndSpreadsAsTheWayThereAndBack) {
  EXPECT_DOUBLE_EQ(reflection_amplitude(ElementKind::wall, 2.0, 0.007), 0.25);
  EXPECT_DOUBLE_EQ(reflection_amplitude(ElementKind::corner, 2.0, 0.007), 0.25);
  EXPECT_DOUBLE_EQ(reflection_amplitude(ElementKind::edge, 2.0, 0.007), 0.25 * edge_diffraction_factor(2.0, 0.007));
  EXPECT_DOUBLE_EQ(reflection_amplitude(ElementKind::none, 2.0, 0.007), 0.0);
}

TEST(Receiver, ReachesItsFullGainAfter38Milliseconds) {
  const Receiver receiver;
  EXPECT_DOUBLE_EQ(receiver.gain(0.019), 0.5);
  EXPECT_DOUBLE_EQ(receiver.gain(0.038), 1.0);
  EXPECT_DOUBLE_EQ(receiver.gain(0.062), 1.0);
  EXPECT_DOUBLE_EQ(receiver.gain(-1.0), 0.0);
}

TEST(TransmitPulse, IsA16CycleBurstOfUnitPeak) {
  const Transducer transducer;
  const Waveform pulse = transmit_pulse(transducer, kFine);
  // 16 / 49.4 kHz = 323.9 us.
  EXPECT_NEAR(static_cast<double>(pulse.sample.size()) * kFine, 323.9e-6, 1e-6);
  EXPECT_NEAR(pulse.peak(), 1.0, 2e-3);
  // The peak is in the middle, and the tone has 16 periods: its imaginary part changes sign 31 times in between.
  int crossings = 0;
  for (std::size_t i = 1; i < pulse.sample.size(); ++i) {
    crossings += (pulse.sample[i].imag() > 0.0) != (pulse.sample[i - 1].imag() > 0.0);
  }
  EXPECT_NEAR(crossings, 31, 1);
}

TEST(TransmitPulse, AveragesEachCellExactly) {
  // Means over cells twice as long are the means of pairs of cells.
  const Waveform fine = transmit_pulse(Transducer{}, 1e-6);
  const Waveform coarse = transmit_pulse(Transducer{}, 2e-6);
  for (std::size_t i = 0; i + 1 < coarse.sample.size(); ++i) {
    EXPECT_NEAR(std::abs(coarse.sample[i] - 0.5 * (fine.sample[2 * i] + fine.sample[2 * i + 1])), 0.0, 1e-13);
  }
}

TEST(EchoWaveform, ArrivesAfterTheWayThereAndBack) {
  const Transducer transducer;
  const double z = 2.0;
  const Waveform echo = echo_waveform(transducer, ElementKind::wall, z, 0.0, kFine);
  // Head-on h_T * h_R is a delta at 2z/c, so the echo is the burst, later by 11.66 ms and scaled by 1/(2z).
  const Waveform pulse = transmit_pulse(transducer, kFine);
  EXPECT_NEAR(echo.start_s - pulse.start_s, 4.0 / transducer.sound_speed_mps, 1e-12);
  EXPECT_NEAR(echo.peak(), 0.25 * pulse.peak(), 1e-12);
}

TEST(EchoWaveform, FallsOffTheAxisAsCosineTimesDirectivitySquared) {
  // The middle of a 16-cycle burst is nearly a steady tone. R = 19.2 mm at 5 degrees: x = 904 * 0.0192 * 0.0872 =
  // 1.513, 2 J1(x)/x = 0.7372, times cos: 0.7344, squared 0.539.
  const Transducer transducer;
  const double head_on = echo_waveform(transducer, ElementKind::wall, 1.0, 0.0, kFine).peak();
  const double inclined = echo_waveform(transducer, ElementKind::wall, 1.0, degrees(5.0), kFine).peak();
  EXPECT_NEAR(inclined / head_on, 0.539, 0.005);
}

TEST(EchoWaveform, AllButVanishesAtTheNull) {
  const Transducer transducer;
  const double null_angle = std::asin(3.8317 / (transducer.wavenumber() * transducer.radius_m));
  const double head_on = echo_waveform(transducer, ElementKind::wall, 1.0, 0.0, kFine).peak();
  EXPECT_LT(decibels(echo_waveform(transducer, ElementKind::wall, 1.0, null_angle, kFine).peak() / head_on), -45.0);
}

TEST(FirstCrossing, ComesSoonerForALouderEcho) {
  Receiver receiver;
  receiver.threshold = 1e-3;
  const Transducer transducer;
  const auto wall = first_crossing(echo_waveform(transducer, ElementKind::wall, 1.0, 0.0, kFine), receiver);
  const auto inclined =
      first_crossing(echo_waveform(transducer, ElementKind::wall, 1.0, degrees(7.0), kFine), receiver);
  ASSERT_TRUE(wall && inclined);
  EXPECT_LT(*wall, *inclined);
  // Both within the burst that begins at 2z/c, less the 27 us that the inclined wave front needs to cross the face.
  const double arrival = 2.0 / transducer.sound_speed_mps;
  EXPECT_GT(*wall, arrival);
  EXPECT_LT(*inclined, arrival + transducer.burst_s());
}

TEST(FirstCrossing, MissesAnEdgeThatIsBelowTheThreshold) {
  // A wall at 3 m: 1/6 * (17.5 ms / 38 ms) = 0.0767; the edge 42.3 dB lower: 0.00059.
  const Transducer transducer;
  Receiver receiver;
  receiver.threshold = 0.001;
  EXPECT_TRUE(first_crossing(echo_waveform(transducer, ElementKind::wall, 3.0, 0.0, kFine), receiver));
  EXPECT_FALSE(first_crossing(echo_waveform(transducer, ElementKind::edge, 3.0, 0.0, kFine), receiver));
  receiver.threshold = 0.0005;
  EXPECT_TRUE(first_crossing(echo_waveform(transducer, ElementKind::edge, 3.0, 0.0, kFine), receiver));
}

TEST(FirstCrossing, MovesWithTheWallWithoutJumps) {
  // Continuous in distance and inclination: no step may move it by more than the geometry (2 dz / c) and a fraction of
  // the burst's rise.
  const Transducer transducer;
  Receiver receiver;
  receiver.threshold = 1e-3;
  std::optional<double> before;
  for (int i = 0; i <= 200; ++i) {
    const double inclination = degrees(-7.0 + 0.07 * i);
    const auto now =
        first_crossing(echo_waveform(transducer, ElementKind::wall, 1.0 + 1e-4 * i, inclination, kFine), receiver);
    ASSERT_TRUE(now) << i;
    if (before) {
      EXPECT_LT(std::abs(*now - *before), 4e-6) << i;
    }
    before = now;
  }
}

TEST(EchoWaveform, BoundsItsWorkAndStaysFiniteAtTheExtremes) {
  for (const double period : {1e-9, 1e-6, 1e-3}) {
    for (const double radius : {0.0, 1e-9, 0.0192, 10.0}) {
      for (const double z : {1e-9, 0.15, 10.67, 1e9}) {
        for (const double inclination : {0.0, 1e-12, 0.2, kPi / 2.0, 2.0}) {
          Transducer transducer;
          transducer.radius_m = radius;
          const Waveform echo = echo_waveform(transducer, ElementKind::wall, z, inclination, period);
          ASSERT_FALSE(echo.sample.empty());
          ASSERT_LE(echo.sample.size(), 10000U);
          ASSERT_TRUE(std::isfinite(echo.peak()));
        }
      }
    }
  }
}

TEST(EchoWaveform, RefusesWhatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(echo_waveform(Transducer{}, ElementKind::wall, nan, 0.0, 1e-6).sample.empty());
  EXPECT_TRUE(echo_waveform(Transducer{}, ElementKind::wall, 1.0, nan, 1e-6).sample.empty());
  EXPECT_TRUE(echo_waveform(Transducer{}, ElementKind::wall, 1.0, 0.0, nan).sample.empty());
}

}  // namespace
}  // namespace echoway
