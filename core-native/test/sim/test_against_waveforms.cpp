// The simulated receiver knows only amplitudes, angles and a rising envelope; Kuc and Siegel's waveforms are worked out
// sample by sample. Where both apply (a plane, one transducer, no noise) they must agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "echoway/acoustics/echo_waveform.hpp"
#include "sim/rooms.hpp"

namespace echoway::sim {
namespace {

constexpr double kAway = 2.0;  // Where plane_margin_db is defined, metres.

struct Case {
  double radius_m;
  double margin_db;
};

void PrintTo(const Case& c, std::ostream* out) { *out << 1e3 * c.radius_m << " mm, " << c.margin_db << " dB"; }

class AgainstWaveforms : public testing::TestWithParam<Case> {
 protected:
  double simulated(double askew_rad) const {
    World world = ideal_world();
    world.transducer_radius_m = GetParam().radius_m;
    world.plane_margin_db = GetParam().margin_db;
    return look(one_room(rooms::rectangle(20.0, 20.0)), world, {20.0 - kAway, 10.0}, to_degrees(askew_rad));
  }

  Transducer transducer() const {
    Transducer transducer;
    transducer.radius_m = GetParam().radius_m;
    return transducer;
  }
  double period() const { return 1.0 / (12.0 * transducer().frequency_hz); }
  Waveform waveform(double askew_rad) const {
    return echo_waveform(transducer(), ElementKind::wall, kAway, askew_rad, period());
  }
  // The threshold that leaves the case's margin to a wall straight ahead.
  Receiver receiver() const {
    Receiver receiver;
    const double time = 2.0 * kAway / transducer().sound_speed_mps;
    receiver.threshold = waveform(0.0).peak() * receiver.gain(time) * std::pow(10.0, -GetParam().margin_db / 20.0);
    return receiver;
  }
  double computed(double askew_rad) const {
    const std::optional<double> time = first_crossing(waveform(askew_rad), receiver());
    return time ? 0.5 * *time * transducer().sound_speed_mps : Firing::kNoEcho;
  }

  template <class Range>
  static double half_angle(Range range) {
    double angle = 0.0;
    while (range(angle) > 0.0 && angle < degrees(60.0)) angle += degrees(0.1);
    return angle;
  }
};

TEST_P(AgainstWaveforms, APlaneAnswersUpToTheSameAngle) {
  const double by_simulator = half_angle([&](double a) { return simulated(a); });
  const double by_waveform = half_angle([&](double a) { return computed(a); });
  RecordProperty("measured_simulated_deg", std::to_string(to_degrees(by_simulator)));
  RecordProperty("measured_computed_deg", std::to_string(to_degrees(by_waveform)));
  EXPECT_NEAR(to_degrees(by_simulator), to_degrees(by_waveform), 1.0);
}

TEST_P(AgainstWaveforms, AnEchoIsTimedAlike) {
  const double limit = half_angle([&](double a) { return simulated(a); });
  const double straight = computed(0.0) - simulated(0.0);
  EXPECT_LT(std::abs(straight), 0.03);
  double farthest = std::abs(straight);
  for (const double share : {0.3, 0.6, 0.9}) {
    const double apart = simulated(share * limit) + straight - computed(share * limit);
    EXPECT_LT(std::abs(apart), 0.03) << share;
    farthest = std::max(farthest, std::abs(apart));
  }
  RecordProperty("measured_range_mm", std::to_string(1e3 * farthest));
}

INSTANTIATE_TEST_SUITE_P(, AgainstWaveforms,
                         testing::Values(Case{0.0145, 12.0}, Case{0.0145, 27.0}, Case{0.0163, 20.0}, Case{0.0163, 27.0},
                                         Case{0.0192, 12.0}, Case{0.0192, 27.0}));

}  // namespace
}  // namespace echoway::sim
