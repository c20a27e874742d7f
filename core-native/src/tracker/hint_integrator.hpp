#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "echoway/motion/motion_hint.hpp"
#include "tracker/still_rate.hpp"

namespace echoway::tracker {

/// Whether a turn (rad/s) is one that people stop or slow down for: 0 to 1.
[[nodiscard]] double on_the_spot(double rate) noexcept;

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

/// Integrates motion hints between firings. Late and missing hints are bridged; impossible ones are
/// ignored. A belt tells of a firing only when it has listened, so hints of later moments may have come
/// before it: they wait for theirs.
class HintIntegrator {
 public:
  void on_hint(const MotionHint& hint) noexcept;
  /// Closes the interval that ends with a firing at `time_s`.
  [[nodiscard]] Interval close(double time_s, double seconds) noexcept;

  /// What the steps heard since the last call (or their absence) say: factors for the likelihood of either gait.
  struct GaitEvidence {
    double standing = 1.0;
    double walking = 1.0;

    [[nodiscard]] double of(bool walks) const noexcept { return walks ? walking : standing; }
  };
  [[nodiscard]] GaitEvidence take_gait_evidence(double time_s, double seconds) noexcept;
  /// Steps a second on the way, the median of the last ones; 0 when nobody is stepping or too few steps were heard.
  [[nodiscard]] double cadence(double time_s) const noexcept;
  /// Forgets how fast steps follow: those heard lately were none of the way's.
  void forget_cadence() noexcept { interval_count_ = 0; }
  /// Whether it is known how fast steps follow.
  [[nodiscard]] bool in_step(double time_s) const noexcept;
  /// What the gyroscope read during a second of standing that has just ended, once.
  [[nodiscard]] std::optional<double> take_still_rate() noexcept { return still_.take(); }
  /// It is `time_s` now, earlier than the times before: the clock was set back.
  void set_clock_back(double time_s) noexcept;

 private:
  void reset_clock() noexcept;
  void note_step_interval(double seconds) noexcept;
  /// Whether the step that has just been heard led on, rather than round on the spot.
  [[nodiscard]] bool step_led_on() noexcept;
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
  double turn_ = 0.0;                ///< Radians since the interval began.
  double turned_ = 0.0;              ///< Radians in all intervals before.
  double turn_at_step_ = 0.0, turn_at_step_before_ = 0.0;   ///< Both together, at the last step and the one before it.
  double rate_ = 0.0;
  double held_ = 0.0;                ///< Of it, counted since the last reading by holding that one.
  double first_rate_time_ = 0.0;
  double last_rate_time_ = -1e300;
  double last_heading_ = 0.0;
  double last_heading_time_ = -1e300;

  StillRate still_;

  double last_step_ = -1e300;
  double step_interval_ = 0.0;       ///< Seconds between steps that led on, smoothed; 0 before two.
  static constexpr std::size_t kIntervals = 5;
  std::array<double, kIntervals> intervals_{};   ///< Seconds between the last steps that led on.
  std::size_t interval_count_ = 0;
  bool fresh_step_ = false;
  double steps_ = 0.0;               ///< Since the interval began.
};

}  // namespace echoway::tracker
