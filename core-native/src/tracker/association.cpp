#include "tracker/association.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {

constexpr double kMostScale = 0.08;        // ln of speed: at -20 and at 70 degrees it is no farther from that at 20.
constexpr double kLeastShare = 1e-3;       // Updates of smaller association probability are skipped.
constexpr double kApart = 0.10;            // Metres that an answer moves a particle in the mean: more is not averaged.

// cov += f * d d^T
void add_outer(Covariance& c, const Covariation& d, double f) noexcept {
  c.xx += f * d.x * d.x;
  c.xy += f * d.x * d.y;
  c.xs += f * d.x * d.s;
  c.xk += f * d.x * d.k;
  c.yy += f * d.y * d.y;
  c.ys += f * d.y * d.s;
  c.yk += f * d.y * d.k;
  c.ss += f * d.s * d.s;
  c.sk += f * d.s * d.k;
  c.kk += f * d.k * d.k;
}

void move(Particle& p, const Covariation& d, double f) noexcept {
  p.position = p.position + Vec2{f * d.x, f * d.y};
  p.speed += f * d.s;
  p.log_scale = std::clamp(p.log_scale + f * d.k, -kMostScale, kMostScale);
}

void correct(Particle& p, const Covariation& d, double innovation, double variance) noexcept {
  move(p, d, innovation / variance);
  add_outer(p.cov, d, -1.0 / variance);
}

double total_share(std::span<const Association> associations) noexcept {
  double share = 0.0;
  for (const Association& a : associations) share += a.share;
  return share;
}

Covariation mean_shift(std::span<const Association> associations) noexcept {
  Covariation shift{0.0, 0.0, 0.0, 0.0};
  for (const Association& a : associations) {
    const double f = a.share * (a.innovation / a.variance);
    shift.x += f * a.with.x;
    shift.y += f * a.with.y;
    shift.s += f * a.with.s;
    shift.k += f * a.with.k;
  }
  return shift;
}

void shift_by_mean(Particle& p, std::span<const Association> associations, const Covariation& shift) noexcept {
  for (const Association& a : associations) {
    const double f = a.innovation / a.variance;
    // Shrinkage of the association's own update, and the spread between associations.
    add_outer(p.cov, a.with, a.share * (f * f - 1.0 / a.variance));
  }
  add_outer(p.cov, shift, -1.0);
  move(p, shift, 1.0);
}

// With the probability that the shares leave nothing in the plan answered, and the particle stays as it is.
void choose(Particle& p, std::span<const Association> associations, Random& random) noexcept {
  double left = random.uniform();
  for (const Association& a : associations) {
    left -= a.share;
    if (left < 0.0) return correct(p, a.with, a.innovation, a.variance);
  }
}

}  // namespace

void merge(Particle& p, std::span<const Association> associations) noexcept {
  if (total_share(associations) > kLeastShare) shift_by_mean(p, associations, mean_shift(associations));
}

void merge_or_choose(Particle& p, std::span<const Association> associations, Random& random) noexcept {
  const double share = total_share(associations);
  if (!(share > kLeastShare)) return;
  const Covariation shift = mean_shift(associations);
  const double apart = kApart * share;   // `shift` counts "none" as no move; an answer's mean one is shift / share.
  if (squared_norm({shift.x, shift.y}) > apart * apart) return choose(p, associations, random);
  shift_by_mean(p, associations, shift);
}

void observe_speed(Particle& p, double speed, double variance) noexcept {
  correct(p, {p.cov.xs, p.cov.ys, p.cov.ss, p.cov.sk}, speed - p.speed, p.cov.ss + variance);
}

void observe_log_scale(Particle& p, double log_scale, double variance) noexcept {
  correct(p, {p.cov.xk, p.cov.yk, p.cov.sk, p.cov.kk}, log_scale - p.log_scale, p.cov.kk + variance);
}

}  // namespace echoway::tracker
