#include "tracker/likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kMostScale = 0.08;        // ln of speed: at -20 and at 70 degrees it is no farther from that at 20.
constexpr double kLeastShare = 1e-3;       // Updates of smaller association probability are skipped.

// P h for the measurement direction h = (gx, gy, 0, range).
struct Direction {
  double x, y, s, k;
};

Direction times(const Covariance& c, Vec2 g, double gk) noexcept {
  return {c.xx * g.x + c.xy * g.y + c.xk * gk, c.xy * g.x + c.yy * g.y + c.yk * gk,
          c.xs * g.x + c.ys * g.y + c.sk * gk, c.xk * g.x + c.yk * g.y + c.kk * gk};
}

// cov += f * d d^T
void add_outer(Covariance& c, const Direction& d, double f) noexcept {
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

void move(Particle& p, const Direction& d, double f) noexcept {
  p.position = p.position + Vec2{f * d.x, f * d.y};
  p.speed += f * d.s;
  p.log_scale = std::clamp(p.log_scale + f * d.k, -kMostScale, kMostScale);
}

struct Association {
  double weight;       // Chance times Gaussian.
  double innovation;
  double variance;
  Direction direction;
};

// Density of the shot's range from what was noted before in no plan.
double remembered(const Particle& p, const Shot& shot, const EchoModel& model) noexcept {
  constexpr double kSpotVariance = 0.12 * 0.12;
  double density = 0.0;
  for (const Spot& spot : shot.spots) {
    if (spot.room != p.room) continue;
    const Vec2 axis{p.facing.x * shot.bearing.x - p.facing.y * shot.bearing.y,
                    p.facing.y * shot.bearing.x + p.facing.x * shot.bearing.y};
    const Vec2 way = spot.at - (p.position + shot.radius * axis);
    const double d = std::sqrt(squared_norm(way));
    if (!(dot(way, axis) > 0.0)) continue;
    const double beam = model.beam(std::abs(cross(axis, way)) / d, true);
    if (beam <= 0.0) continue;
    const double off = shot.range - d * (1.0 + p.log_scale);
    const double variance = kSpotVariance + model.variance(d) + 0.5 * (p.cov.xx + p.cov.yy);
    density += spot.strength * beam * kInvSqrtTwoPi / std::sqrt(variance) * fast_exp(-0.5 * off * off / variance);
  }
  return density;
}

}  // namespace

Shot shot_of(const Record& record, const BeltConfig& belt, Vec2 bearing) noexcept {
  Shot shot;
  shot.sensor = record.sensor;
  shot.bearing = bearing;
  shot.bearing_rad = belt.bearing(record.sensor);
  shot.radius = belt.radius_m;
  shot.range = record.range;
  shot.echo = record.echo;
  shot.trust = record.trust;
  shot.novelty = record.novelty;
  return shot;
}

Outcome assimilate(Particle& p, const Shot& shot, const EchoModel& model, scene::Scene& scene) noexcept {
  const ExpectedEchoes expected = expect(p, shot, model, scene);
  if (!shot.echo) {
    double survival = 1.0;
    for (int j = 0; j < expected.count; ++j) survival *= 1.0 - expected.echo[static_cast<std::size_t>(j)].chance;
    const double silent = shot.trust * model.silence(survival) + (1.0 - shot.trust) * model.quiet();
    return {silent, silent, 0.0};
  }

  std::array<Association, ExpectedEchoes::kMax> found;
  std::size_t count = 0;
  double survival = 1.0;
  double survival_at_range = 1.0;
  double explained = 0.0;
  for (int j = 0; j < expected.count; ++j) {
    const ExpectedEcho& e = expected.echo[static_cast<std::size_t>(j)];
    const double innovation = shot.range - e.range * (1.0 + p.log_scale);
    const double noise = model.variance(e.range) + e.extra_variance;
    const Direction direction = times(p.cov, e.gradient(), e.range);
    const double own = direction.x * e.gradient_x + direction.y * e.gradient_y + direction.k * e.range;
    const double variance = noise + std::max(own, 0.0);
    const double normalized = innovation * innovation / variance;
    if (normalized < kGate2) {
      const double density = kInvSqrtTwoPi / std::sqrt(variance) * fast_exp(-0.5 * normalized);
      found[count++] = {survival * e.chance * density, innovation,
                        std::max(own, 0.0) + noise / shot.novelty, direction};
      explained += found[count - 1].weight;
    }
    survival *= 1.0 - e.chance;
    if (e.range < shot.range) survival_at_range = survival;
  }
  double repeated = 0.0;
  for (const Repeat& r : shot.repeats) {
    repeated += r.density * (1.0 / 255.0) * p.strangers[static_cast<std::size_t>(r.sensor)];
  }
  const double again = survival_at_range * (repeated + remembered(p, shot, model));
  const double total = model.echo(explained, survival_at_range, shot.range, again);
  const double density = std::max(kLeastDensity, total);
  const double plan = std::max(kLeastDensity, total - model.heard() * again);

  const double scale = shot.trust * model.heard() * model.quiet() / density;
  double mean_gain = 0.0;
  for (std::size_t j = 0; j < count; ++j) mean_gain += scale * found[j].weight;
  if (mean_gain > kLeastShare) {
    Direction shift{0.0, 0.0, 0.0, 0.0};
    for (std::size_t j = 0; j < count; ++j) {
      const Association& a = found[j];
      const double share = scale * a.weight;
      const double f = a.innovation / a.variance;
      shift.x += share * f * a.direction.x;
      shift.y += share * f * a.direction.y;
      shift.s += share * f * a.direction.s;
      shift.k += share * f * a.direction.k;
    }
    for (std::size_t j = 0; j < count; ++j) {
      const Association& a = found[j];
      const double share = scale * a.weight;
      const double f = a.innovation / a.variance;
      // Shrinkage of the association's own update, and the spread between associations.
      add_outer(p.cov, a.direction, share * (f * f - 1.0 / a.variance));
    }
    add_outer(p.cov, shift, -1.0);
    move(p, shift, 1.0);
  }
  const double anything = (1.0 - shot.trust) * model.unexplained(shot.range);
  p.strangers[static_cast<std::size_t>(shot.sensor)] =
      static_cast<std::uint8_t>(255.0 * std::clamp(1.0 - mean_gain, 0.0, 1.0));
  return {shot.trust * density + anything, shot.trust * plan + anything, mean_gain};
}

void observe_log_scale(Particle& p, double log_scale, double variance) noexcept {
  const Direction d{p.cov.xk, p.cov.yk, p.cov.sk, p.cov.kk};
  const double s = p.cov.kk + variance;
  move(p, d, (log_scale - p.log_scale) / s);
  add_outer(p.cov, d, -1.0 / s);
}

}  // namespace echoway::tracker
