#include "tracker/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "echoway/geometry/pose2.hpp"
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

// Whether a turn is one that people stop or slow down for, from its speed: 0 to 1.
double on_the_spot(double rate) noexcept {
  return std::clamp((std::abs(rate) - kWalkersTurn) / (kTurnOnTheSpot - kWalkersTurn), 0.0, 1.0);
}

void scale_speed_row(Covariance& c, double f) noexcept {
  c.xs *= f;
  c.ys *= f;
  c.sk *= f;
  c.ss *= f * f;
}

}  // namespace

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
      if (since < kLongestStep) note_step_interval(since);
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

Stride::Stride(const Interval& interval, const MotionParameters& m, double pace) noexcept
    : parameters_(&m), interval_(interval), pace_(pace) {
  const double dt = interval.seconds;
  const double root = std::sqrt(std::max(dt, 0.0));
  if (interval.turn_known && dt > 0.0) turning_ = on_the_spot(interval.turn / dt);
  turn_sigma_ = (interval.turn_known ? m.gyro_noise : m.turn_noise) * root;
  bias_sigma_ = m.gyro_bias_drift * root;
  turn_drift_ = m.turn_drift * root;
  sway_variance_ = m.sway * m.sway * dt;
  scale_variance_ = m.scale_drift * m.scale_drift * dt;
  const double drift = (interval.in_step ? m.pace_drift_in_step : m.pace_drift) * std::max(pace, m.slowest_pace);
  pace_variance_ = drift * drift * dt;
  pace_return_ = std::min(1.0, dt / m.pace_memory);
}

void Stride::predict(Particle& p) const noexcept {
  const double dx = p.facing.x * interval_.seconds;
  const double dy = p.facing.y * interval_.seconds;
  p.position = p.position + Vec2{dx * p.speed, dy * p.speed};
  Covariance& c = p.cov;
  c.xx += 2.0 * dx * c.xs + dx * dx * c.ss + sway_variance_;
  c.xy += dx * c.ys + dy * c.xs + dx * dy * c.ss;
  c.yy += 2.0 * dy * c.ys + dy * dy * c.ss + sway_variance_;
  c.xs += dx * c.ss;
  c.ys += dy * c.ss;
  c.xk += dx * c.sk;
  c.yk += dy * c.sk;
  c.kk += scale_variance_;
  if (p.gait == Gait::walking) {
    p.speed += pace_return_ * (pace_ - p.speed);
    scale_speed_row(c, 1.0 - pace_return_);
    c.ss += pace_variance_;
  }
  p.speed = std::clamp(p.speed, -parameters_->fastest, parameters_->fastest);
}

void Stride::change_gait(Particle& p, Random& random) const noexcept {
  const MotionParameters& m = *parameters_;
  const double turning = interval_.turn_known ? turning_ : on_the_spot(p.turn_rate);
  const double rate = p.gait == Gait::walking ? m.stop_rate + turning * m.turning_stop_rate : m.start_rate + turning * m.turning_start_rate;
  if (random.uniform() < fast_exp(-rate * interval_.seconds)) return;
  const double lost = m.change_seconds * std::max(std::abs(p.gait == Gait::walking ? p.speed : pace_), m.slowest_pace);
  if (p.gait == Gait::walking) {
    p.gait = Gait::standing;
    forget_speed(p, 0.0, m.standing_sigma);
  } else {
    p.gait = Gait::walking;
    if (random.uniform() < m.new_pace_share) {
      forget_speed(p, random.uniform(m.slowest_pace, m.fastest_pace), m.new_pace_sigma);
    } else {
      forget_speed(p, pace_, m.start_sigma);
    }
  }
  const double along = lost * lost;
  p.cov.xx += along * p.facing.x * p.facing.x;
  p.cov.xy += along * p.facing.x * p.facing.y;
  p.cov.yy += along * p.facing.y * p.facing.y;
}

void Stride::turn_unaided(Particle& p, Random& random) const noexcept {
  const MotionParameters& m = *parameters_;
  const double dt = interval_.seconds;
  const double straight = 3.0 * m.straight_sigma;
  const bool turning = std::abs(p.turn_rate) > straight;
  const double begin = p.gait == Gait::walking ? m.turn_rate_walking : m.turn_rate_standing;
  const double u = random.uniform();
  const double dice = turning ? u / ((m.turn_end_rate + m.turn_change_rate) * dt) : u / (begin * dt);
  if (dice < 1.0) {
    const bool ends = turning && dice * (m.turn_end_rate + m.turn_change_rate) < m.turn_end_rate;
    if (ends) {
      p.turn_rate = m.straight_sigma * cheap_normal(random);
    } else {
      const double rate = random.uniform(m.turn_slow, m.turn_fast);
      const bool left = turning ? p.turn_rate > 0.0 : random.uniform() < 0.5;
      p.turn_rate = left ? rate : -rate;
    }
  } else if (turning) {
    p.turn_rate += turn_drift_ * cheap_normal(random);
  } else if (random.uniform() < 2.0 * dt) {
    p.turn_rate = m.straight_sigma * cheap_normal(random);   // Sway.
  }
  p.heading += p.turn_rate * dt + turn_sigma_ * cheap_normal(random);
}

void Stride::advance(Particle& p, Random& random) const noexcept {
  if (!(interval_.seconds > 0.0)) return;
  const double before = p.heading;
  if (interval_.turn_known) {
    p.heading += interval_.turn_without(p.gyro_bias) + turn_sigma_ * cheap_normal(random);
    p.gyro_bias += bias_sigma_ * cheap_normal(random);
  } else {
    turn_unaided(p, random);
  }
  // The mean direction over the interval carries the walk; the final one aims the sensors.
  const SinCos mid = fast_sincos(0.5 * (before + p.heading));
  p.facing = {mid.cos, mid.sin};
  if (p.gait != Gait::away) {
    change_gait(p, random);
    predict(p);
  }
  p.heading = wrap_near(p.heading);
  const SinCos end = fast_sincos(p.heading);
  p.facing = {end.cos, end.sin};
}

}  // namespace echoway::tracker
