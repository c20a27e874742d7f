#pragma once

#include "echoway/random.hpp"
#include "tracker/hint_integrator.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// How people walk, and how their phone's sensors see it. Standard deviations; "per root second"
/// ones grow with the root of time.
struct MotionParameters {
  double start_speed = 0.5, start_speed_sigma = 0.30;     ///< m/s, before anything is known.
  double pace_drift = 0.12;              ///< Of the pace, per root second, while walking,
  double pace_drift_in_step = 0.06;      ///< and while steps are heard, whose rhythm tells most of it,
  double pace_memory = 5.0;              ///< with a return to the wearer's usual pace in so many seconds.
  double stop_rate = 0.12;               ///< 1/s: walking ends,
  double start_rate = 0.35;              ///< and begins.
  double turning_stop_rate = 2.0;        ///< 1/s, added to these in a turn as fast as people's on the spot: in walking
  double turning_start_rate = 1.0;       ///< they slow down for it.
  double start_sigma = 0.08;             ///< m/s: how well the usual pace tells the pace of a new start ...
  double new_pace_share = 0.1;           ///< ... unless the wearer sets out, so often, at another one,
  double slowest_pace = 0.3, fastest_pace = 1.6;   ///< m/s: anything between these,
  double new_pace_sigma = 0.15;          ///< of which a particle stands for so much.
  double change_seconds = 0.20;          ///< Of walking that a start or stop takes or gives.
  double standing_sigma = 0.03;          ///< m/s: shuffling.
  double sway = 0.04;                    ///< m per root second, any direction: gait, side steps.
  double gyro_bias_sigma = degrees(0.8); ///< rad/s, as phones come out of their own calibration.
  double gyro_bias_drift = degrees(0.05);///< rad/s per root second.
  double gyro_noise = degrees(3.0);      ///< rad per root second: more than gyroscopes' own, as phones swing on thighs.
  // Without a gyroscope. Rates in 1/s, speeds in rad/s.
  double turn_rate_walking = 0.45;       ///< Turns begin so often while walking,
  double turn_rate_standing = 0.70;      ///< so often while standing,
  double turn_end_rate = 0.80;           ///< end so often,
  double turn_change_rate = 0.60;        ///< and change their speed so often.
  double turn_slow = degrees(15.0);      ///< Between so fast
  double turn_fast = degrees(120.0);     ///< and so fast, either way.
  double turn_drift = degrees(30.0);     ///< rad/s per root second, of a turn's speed.
  double straight_sigma = degrees(4.0);  ///< What is left of turning on a straight way.
  double turn_noise = degrees(0.8);      ///< rad per root second, of any turn.
  double scale_sigma = 0.015;            ///< ln of the sound-speed scale at the start (9 K) ...
  double scale_drift = 2e-4;             ///< ... and per root second.
  double fastest = 2.2;                  ///< m/s.
};

/// An interval prepared for all particles: whatever is the same for each is worked out once.
class Stride {
 public:
  Stride() = default;
  /// `pace` is the wearer's usual walking speed, `steps` what steps tell of their gait at the interval's end.
  /// `parameters` must outlive the stride.
  Stride(const Interval& interval, const MotionParameters& parameters, double pace,
         const HintIntegrator::GaitEvidence& steps = {}) noexcept;

  /// Moves `particle` through the interval, with noise from `random`, and weighs it by the steps, unless it is away.
  void advance(Particle& particle, Random& random) const noexcept;

 private:
  void turn_unaided(Particle& particle, Random& random) const noexcept;
  [[nodiscard]] bool draw_change(Particle& particle, Random& random) const noexcept;
  void change_gait(Particle& particle, Random& random) const noexcept;
  void predict(Particle& particle) const noexcept;

  const MotionParameters* parameters_ = nullptr;
  Interval interval_{};
  double pace_ = 0.0;
  HintIntegrator::GaitEvidence steps_{};
  double turning_ = 0.0;          ///< Whether the turn is one on the spot, when a gyroscope told it.
  double turn_sigma_ = 0.0;       ///< What the interval adds to the heading,
  double bias_sigma_ = 0.0;       ///< to the gyroscope's bias
  double turn_drift_ = 0.0;       ///< and to the speed of a turn.
  double sway_variance_ = 0.0;
  double scale_variance_ = 0.0;
  double pace_variance_ = 0.0;
  double pace_return_ = 0.0;      ///< Share of the way back to the usual pace.
};

}  // namespace echoway::tracker
