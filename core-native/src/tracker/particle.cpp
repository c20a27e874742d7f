#include "tracker/particle.hpp"

#include <cmath>

namespace echoway::tracker {

void turn(Particle& p, Vec2 rotation) noexcept {
  const Vec2 r = rotation;
  p.heading = wrap_near(p.heading + std::atan2(r.y, r.x));
  p.facing = rotated(p.facing, r);
  p.strangers.turn(r);
  Covariance& c = p.cov;
  const double xx = c.xx, xy = c.xy, yy = c.yy, xs = c.xs, ys = c.ys, xk = c.xk, yk = c.yk;
  c.xx = r.x * r.x * xx - 2.0 * r.x * r.y * xy + r.y * r.y * yy;
  c.yy = r.y * r.y * xx + 2.0 * r.x * r.y * xy + r.x * r.x * yy;
  c.xy = r.x * r.y * (xx - yy) + (r.x * r.x - r.y * r.y) * xy;
  c.xs = r.x * xs - r.y * ys;
  c.ys = r.y * xs + r.x * ys;
  c.xk = r.x * xk - r.y * yk;
  c.yk = r.y * xk + r.x * yk;
}

}  // namespace echoway::tracker
