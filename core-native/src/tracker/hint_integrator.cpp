#include "tracker/hint_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "echoway/geometry/pose2.hpp"
#include "echoway/units.hpp"
#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kStaleRate = 0.5;          // Seconds for which a yaw rate is held.
constexpr double kFurthestAhead = 5.0;      // Seconds that hints may run ahead of the firings.
constexpr double kFastestTurn = 10.0;       // rad/s; nobody turns faster, a gyroscope that says so is broken.
constexpr double kStepLateness = 0.3;
constexpr double kLogStepMissed = -2.5;     // A detector misses about one step of a dozen.
constexpr double kRecently = 30.0;          // Seconds since a step for which a detector is fully believed.
constexpr double kSettled = 1.5;            // Seconds after a step in which the wearer may still be stepping.
constexpr double kShortestStep = 0.25;      // Seconds between two real steps.
constexpr double kLongestStep = 2.0;
constexpr double kDefaultStep = 1.0;
constexpr std::size_t kFewestIntervals = 2;
constexpr double kStepWithoutWalking = 0.05;   // Likelihood of a step event while standing, against walking,
constexpr double kStepOnTheSpot = 0.6;         // and while turning: feet that turn step as well.
constexpr double kWalkersTurn = degrees(20.0); // rad/s: faster, and a turn is more and more likely one on the spot,
constexpr double kTurnOnTheSpot = degrees(60.0);   // from here on as surely as a turn can tell.
constexpr double kTurnOfAStep = degrees(25.0);     // Who turns by more with a step, and with two, turns on the spot.

}  // namespace

double on_the_spot(double rate) noexcept {
  return std::clamp((std::abs(rate) - kWalkersTurn) / (kTurnOnTheSpot - kWalkersTurn), 0.0, 1.0);
}

void HintIntegrator::integrate_to(double time_s) noexcept {
  if (!clock_set_) {
    clock_ = time_s;
    clock_set_ = true;
    return;
  }
  const double dt = time_s - clock_;
  if (!(dt > 0.0)) return;
  hold_rate(std::min(dt, std::max(0.0, last_rate_time_ + kStaleRate - clock_)));
  clock_ = time_s;
}

void HintIntegrator::hold_rate(double seconds) noexcept {
  held_ += rate_ * seconds;
  turn_ += rate_ * seconds;
}

// A gyroscope reports the turn of the time that has just passed: its filter averages over about as long as its readings
// lie apart. What was held for that time in want of the reading is replaced, also when it came late.
void HintIntegrator::on_yaw_rate(double time_s, double rate) noexcept {
  const double apart = time_s - last_rate_time_;
  if (apart <= kStaleRate) {
    turn_ += rate * apart - held_;
  } else {
    integrate_to(time_s);
  }
  held_ = 0.0;
  rate_ = rate;
  last_rate_time_ = time_s;
  hold_rate(std::clamp(clock_ - time_s, 0.0, kStaleRate));
  clock_ = std::max(clock_, time_s);
}

// What still waits for a later time was stamped before the clock was set back: it would count when that time returns.
void HintIntegrator::set_clock_back(double time_s) noexcept {
  const auto waiting = waiting_.begin() + static_cast<std::ptrdiff_t>(waiting_count_);
  const auto later = [time_s](const MotionHint& hint) { return hint.time_s > time_s; };
  const auto kept = std::remove_if(waiting_.begin(), waiting, later);
  waiting_count_ = static_cast<std::size_t>(kept - waiting_.begin());
  reset_clock();
}

void HintIntegrator::reset_clock() noexcept {
  clock_set_ = false;
  turn_ = held_ = 0.0;
  last_rate_time_ = last_heading_time_ = last_step_ = -1e300;
  interval_count_ = 0;
  still_.reset();
}

void HintIntegrator::on_hint(const MotionHint& hint) noexcept {
  if (!std::isfinite(hint.time_s) || !std::isfinite(hint.value)) return;
  if (waiting_count_ == kMostWaiting) {   // No belt is heard.
    take(waiting_.front());
    std::shift_left(waiting_.begin(), waiting_.end(), 1);
    --waiting_count_;
  }
  waiting_[waiting_count_++] = hint;
}

// Those of the time up to then, in the order in which they came; what is too far ahead to be true is dropped.
void HintIntegrator::take_waiting(double time_s) noexcept {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < waiting_count_; ++i) {
    const MotionHint& hint = waiting_[i];
    if (hint.time_s <= time_s) {
      take(hint);
    } else if (hint.time_s < time_s + kFurthestAhead) {
      waiting_[kept++] = hint;
    }
  }
  waiting_count_ = kept;
}

void HintIntegrator::take(const MotionHint& hint) noexcept {
  switch (hint.kind) {
    case MotionKind::yaw_rate:
      if (std::abs(hint.value) > kFastestTurn || hint.time_s < last_rate_time_) return;
      if (last_rate_time_ < -1e299) first_rate_time_ = hint.time_s;
      on_yaw_rate(hint.time_s, hint.value);
      still_.note(hint.time_s, hint.value, hint.time_s - last_step_ < kSettled);
      break;
    case MotionKind::heading: {
      const double dt = hint.time_s - last_heading_time_;
      if (dt <= 0.0) return;
      const double change = wrap_angle(hint.value - last_heading_);
      last_heading_ = hint.value;
      last_heading_time_ = hint.time_s;
      // A compass only stands in for a gyroscope that is not there.
      if (hint.time_s - last_rate_time_ < kStaleRate || dt > kStaleRate) return;
      integrate_to(hint.time_s);
      turn_ += change;
      break;
    }
    case MotionKind::step: {
      const double since = hint.time_s - last_step_;
      if (since < kShortestStep) return;
      const bool led_on = step_led_on();
      if (since < kLongestStep && led_on) note_step_interval(since);
      last_step_ = hint.time_s;
      fresh_step_ = true;
      steps_ += 1.0 - turning_on_the_spot(hint.time_s);
      break;
    }
  }
}

void HintIntegrator::note_step_interval(double seconds) noexcept {
  intervals_[interval_count_++ % kIntervals] = seconds;
  step_interval_ = step_interval_ > 0.0 ? 0.7 * step_interval_ + 0.3 * seconds : seconds;
}

// Feet that turn on the spot step faster than on the way, and go nowhere. A phone on a thigh swings as far, and back.
bool HintIntegrator::step_led_on() noexcept {
  const double turn = turned_ + turn_;
  const double step = std::abs(turn - turn_at_step_), two_steps = std::abs(turn - turn_at_step_before_);
  turn_at_step_before_ = std::exchange(turn_at_step_, turn);
  return step < kTurnOfAStep || two_steps < kTurnOfAStep;
}

bool HintIntegrator::in_step(double time_s) const noexcept {
  return interval_count_ >= kFewestIntervals && time_s - last_step_ <= kLongestStep;
}

double HintIntegrator::turning_on_the_spot(double time_s) const noexcept {
  return time_s - last_rate_time_ < kStaleRate ? on_the_spot(rate_) : 0.0;
}

// A step missed doubles an interval and one invented splits one: the median minds neither.
double HintIntegrator::cadence(double time_s) const noexcept {
  if (!in_step(time_s)) return 0.0;
  const std::size_t count = std::min(interval_count_, kIntervals);
  std::array<double, kIntervals> sorted;
  for (std::size_t i = 0; i < kIntervals; ++i) sorted[i] = intervals_[i % count];
  std::sort(sorted.begin(), sorted.end());
  return 1.0 / sorted[kIntervals / 2];
}

// One hint stamped far ahead would make every later one look old.
void HintIntegrator::forget_future(double time_s) noexcept {
  const double newest = std::max({clock_set_ ? clock_ : time_s, last_rate_time_, last_heading_time_, last_step_});
  if (newest > time_s + kFurthestAhead) reset_clock();
}

Interval HintIntegrator::close(double time_s, double seconds) noexcept {
  forget_future(time_s);
  take_waiting(time_s);
  integrate_to(time_s);
  Interval interval;
  interval.seconds = seconds;
  interval.turn_known = time_s - last_rate_time_ < kStaleRate || time_s - last_heading_time_ < kStaleRate;
  interval.turn = turn_;
  turned_ += turn_;
  interval.in_step = in_step(time_s);
  interval.steps = std::exchange(steps_, 0.0);
  turn_ = 0.0;
  return interval;
}

HintIntegrator::GaitEvidence HintIntegrator::take_gait_evidence(double time_s, double seconds) noexcept {
  GaitEvidence evidence;
  if (fresh_step_) {
    fresh_step_ = false;
    const double turning = turning_on_the_spot(time_s);
    evidence.standing = kStepWithoutWalking + turning * (kStepOnTheSpot - kStepWithoutWalking);
    return evidence;
  }
  // A phone with a gyroscope counts steps too, most likely.
  const bool heard = last_step_ > -1e299;
  if (!heard && time_s - last_rate_time_ > kStaleRate) return evidence;
  const double since = time_s - (heard ? last_step_ : first_rate_time_);
  const double trust = heard && since < kRecently ? 1.0 : 0.5;   // A detector may be slow to start, or stop for good.
  // A walker's next step is overdue a little after the usual interval; the detector may miss one and is late.
  const double unknown = heard ? kDefaultStep : kLongestStep;
  const double usual = step_interval_ > 0.0 ? std::min(step_interval_, kLongestStep) : unknown;
  if (since > 0.9 * usual + kStepLateness) evidence.walking = fast_exp(kLogStepMissed * trust / usual * seconds);
  return evidence;
}

}  // namespace echoway::tracker
