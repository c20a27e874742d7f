#include "tracker/motion.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"
#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

void scale_speed_row(Covariance& c, double f) noexcept {
  c.xs *= f;
  c.ys *= f;
  c.sk *= f;
  c.ss *= f * f;
}

}  // namespace

Stride::Stride(const Interval& interval, const MotionParameters& m, double pace,
               const HintIntegrator::GaitEvidence& steps) noexcept
    : parameters_(&m), interval_(interval), pace_(pace), steps_(steps) {
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
  const Vec2 step{dx * p.speed, dy * p.speed};
  p.position = p.position + step;
  p.strangers.move(step);
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

// Whether a gait ends, drawn with what the steps tell in mind (the optimal importance density: Doucet, Godsill and
// Andrieu 2000). By chance alone one in fifty of those who stand would set out at a first step, and all who walk on
// descend from them.
bool Stride::draw_change(Particle& p, Random& random) const noexcept {
  const MotionParameters& m = *parameters_;
  const bool walks = p.gait == Gait::walking;
  const double turning = interval_.turn_known ? turning_ : on_the_spot(p.turn_rate);
  const double rate = walks ? m.stop_rate + turning * m.turning_stop_rate
                            : m.start_rate + turning * m.turning_start_rate;
  const double stays = fast_exp(-rate * interval_.seconds);
  const double same = stays * steps_.of(walks);
  const double other = (1.0 - stays) * steps_.of(!walks);
  p.weight *= same + other;
  return !(random.uniform() * (same + other) < same);
}

void Stride::change_gait(Particle& p, Random& random) const noexcept {
  const MotionParameters& m = *parameters_;
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
  if (!(interval_.seconds > 0.0)) {
    if (p.gait != Gait::away) p.weight *= steps_.of(p.gait == Gait::walking);
    return;
  }
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
    if (draw_change(p, random)) change_gait(p, random);
    predict(p);
  } else {
    p.strangers.move(interval_.seconds * p.speed * p.facing);   // Treads are climbed about as fast.
  }
  p.heading = wrap_near(p.heading);
  face_heading(p);
}

}  // namespace echoway::tracker
