#pragma once

#include <span>

#include "echoway/geometry/vec2.hpp"
#include "echoway/random.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// P h: how a particle's position (metres^2), speed (metres^2 a second) and log sound-speed scale (metres) vary with a
/// range of gradient h.
struct Covariation {
  double x, y, s, k;
};

/// The same for a range of this gradient over position and of gradient `range`, metres, over the log scale.
[[nodiscard]] inline Covariation covariation(const Covariance& c, Vec2 gradient, double range) noexcept {
  return {c.xx * gradient.x + c.xy * gradient.y + c.xk * range, c.xy * gradient.x + c.yy * gradient.y + c.yk * range,
          c.xs * gradient.x + c.ys * gradient.y + c.sk * range, c.xk * gradient.x + c.yk * gradient.y + c.kk * range};
}

/// One reflector that may have answered.
struct Association {
  double share;             ///< Probability that it did. Those of all that may have add up to 1 at most.
  double innovation;        ///< Metres: what was read less what was expected,
  double variance;          ///< and the variance of that, metres^2, above 0.
  Covariation with;         ///< How the particle varies with what was expected.
};

/// The particle's Gaussian given that one of `associations` answered, or none of them with the rest of the probability:
/// the hypotheses merged into one (probabilistic data association, Bar-Shalom and Fortmann 1988, section 6.4).
void merge(Particle& particle, std::span<const Association> associations) noexcept;

/// The same as long as what answered hardly matters to where the particle lies: the answers move it by 0.1 m at most,
/// in their mean. Otherwise it takes one of the hypotheses, drawn by its probability (Särkkä, Vehtari and Lampinen
/// 2007): a mean of "that is the wall" and "that is a cupboard before it" is a place where the wearer is not in either
/// case.
void merge_or_choose(Particle& particle, std::span<const Association> associations, Random& random) noexcept;

/// Kalman update with a reading of the speed itself, m/s, of variance `variance` > 0.
void observe_speed(Particle& particle, double speed, double variance) noexcept;
/// Kalman update with a reading of the log sound-speed scale itself, of variance `variance` > 0.
void observe_log_scale(Particle& particle, double log_scale, double variance) noexcept;

}  // namespace echoway::tracker
