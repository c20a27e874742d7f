#pragma once

#include <array>
#include <optional>

#include "echoway/motion/motion_hint.hpp"
#include "echoway/random.hpp"
#include "tracker/still_rate.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// How people walk, and how their phone's sensors see it. Standard deviations; "per root second" ones grow with the root
/// of time.
struct MotionParameters {
  double start_speed = 0.5, start_speed_sigma = 0.30;     ///< m/s, before anything is known.
  double pace_drift = 0.12;              ///< Of the pace, per root second, while walking,
  double pace_drift_in_step = 0.06;      ///< and while steps are heard, whose rhythm tells most of it,
  double pace_memory = 5.0;              ///< with a return to the wearer's usual pace in so many seconds.
  double stop_rate = 0.12;               ///< 1/s: walking ends,
  double start_rate = 0.35;              ///< and begins.
  double turning_stop_rate = 2.0;        ///< 1/s, added to these in a turn as fast as people make on the spot: in walking
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
  double gyro_noise = degrees(3.0);      ///< rad per root second: more than any gyroscope's own, for phones swing on thighs.
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

/// What the hints say about the time between two firings.
struct Interval {
  double seconds = 0.0;
  bool turn_known = false;
  double turn = 0.0;                     ///< Radians, when known; includes the gyroscope's bias.
  double steps = 0.0;                    ///< Heard; those of a turn on the spot lead nowhere.
  bool in_step = false;                  ///< Steps are heard, and how fast they follow.

  /// The turn with that bias (rad/s) taken out.
  [[nodiscard]] double turn_without(double bias) const noexcept { return turn - bias * seconds; }
};

/// Integrates motion hints between firings. Late and missing hints are bridged; impossible ones are ignored. A belt tells of
/// a firing only when it has listened, so hints of later moments may have come before it: they wait for theirs.
class HintIntegrator {
 public:
  void on_hint(const MotionHint& hint) noexcept;
  /// Closes the interval that ends with a firing at `time_s`.
  [[nodiscard]] Interval close(double time_s, double seconds) noexcept;

  /// What the steps heard since the last call (or their absence) say: factors for the likelihood of either gait.
  struct GaitEvidence {
    double standing = 1.0;
    double walking = 1.0;
  };
  [[nodiscard]] GaitEvidence take_gait_evidence(double time_s, double seconds) noexcept;
  /// Steps a second, the median of the last ones; 0 when nobody is stepping or too few steps were heard.
  [[nodiscard]] double cadence(double time_s) const noexcept;
  /// Whether it is known how fast steps follow.
  [[nodiscard]] bool in_step(double time_s) const noexcept;
  /// What the gyroscope read during a second of standing that has just ended, once.
  [[nodiscard]] std::optional<double> take_still_rate() noexcept { return still_.take(); }
  void reset_clock() noexcept;

 private:
  void note_step_interval(double seconds) noexcept;
  /// Between 0 and 1, by the gyroscope; 0 without one.
  [[nodiscard]] double turning_on_the_spot(double time_s) const noexcept;

  void take(const MotionHint& hint) noexcept;
  void take_waiting(double time_s) noexcept;
  void on_yaw_rate(double time_s, double rate) noexcept;
  void integrate_to(double time_s) noexcept;
  /// Counts that long of the last rate, until a reading says better.
  void hold_rate(double seconds) noexcept;
  void forget_future(double time_s) noexcept;

  static constexpr std::size_t kMostWaiting = 64;   ///< A third of a second of the fastest gyroscope.
  std::array<MotionHint, kMostWaiting> waiting_{};   ///< In the order in which they came.
  std::size_t waiting_count_ = 0;

  double clock_ = 0.0;
  bool clock_set_ = false;
  double turn_ = 0.0;                ///< Since the interval began.
  double rate_ = 0.0;
  double held_ = 0.0;                ///< Of it, counted since the last reading by holding that one.
  double first_rate_time_ = 0.0;
  double last_rate_time_ = -1e300;
  double last_heading_ = 0.0;
  double last_heading_time_ = -1e300;

  StillRate still_;

  double last_step_ = -1e300;
  double step_interval_ = 0.0;       ///< Smoothed; 0 before two steps.
  static constexpr std::size_t kIntervals = 5;
  std::array<double, kIntervals> intervals_{};   ///< Seconds between the last steps.
  std::size_t interval_count_ = 0;
  bool fresh_step_ = false;
  double steps_ = 0.0;               ///< Since the interval began.
};

/// An interval prepared for all particles: whatever is the same for each is worked out once.
class Stride {
 public:
  Stride() = default;
  /// `pace` is the wearer's usual walking speed. `parameters` must outlive the stride.
  Stride(const Interval& interval, const MotionParameters& parameters, double pace) noexcept;

  /// Moves `particle` through the interval, with noise from `random`.
  void advance(Particle& particle, Random& random) const noexcept;

 private:
  void turn_unaided(Particle& particle, Random& random) const noexcept;
  void change_gait(Particle& particle, Random& random) const noexcept;
  void predict(Particle& particle) const noexcept;

  const MotionParameters* parameters_ = nullptr;
  Interval interval_{};
  double pace_ = 0.0;
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
