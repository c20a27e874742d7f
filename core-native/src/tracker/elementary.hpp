#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "echoway/random.hpp"
#include "echoway/units.hpp"

/// Elementary functions for the inner loop. They use nothing but IEEE additions, multiplications and divisions,
/// so they give the same bits with every compiler, C library and processor (a C library's exp and sin need not),
/// and they cost a few nanoseconds.
namespace echoway::tracker {

/// exp(x) to 1e-14 relative for |x| <= 700; 0 below -700, exp(700) above. Cody and Waite's reduction to |r| <= ln(2)/2,
/// then the Taylor series to degree 11 (what is left out is below r^12 / 12! = 7e-15).
[[nodiscard]] inline double fast_exp(double x) noexcept {
  if (!(x >= -700.0)) return 0.0;
  if (x > 700.0) x = 700.0;
  constexpr double kLog2e = 1.4426950408889634;
  constexpr double kLn2High = 6.93147180369123816490e-01;
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  const double n = std::floor(x * kLog2e + 0.5);
  const double r = (x - n * kLn2High) - n * kLn2Low;
  double p = 1.0 / 39916800.0;
  p = p * r + 1.0 / 3628800.0;
  p = p * r + 1.0 / 362880.0;
  p = p * r + 1.0 / 40320.0;
  p = p * r + 1.0 / 5040.0;
  p = p * r + 1.0 / 720.0;
  p = p * r + 1.0 / 120.0;
  p = p * r + 1.0 / 24.0;
  p = p * r + 1.0 / 6.0;
  p = p * r + 0.5;
  p = p * r + 1.0;
  p = p * r + 1.0;
  const auto exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(n) + 1023);
  return p * std::bit_cast<double>(exponent << 52);
}

/// Natural logarithm of a positive normal number, to 4e-16 absolute near 1 and 1e-15 relative elsewhere; -745 for zero,
/// denormal or negative arguments. 2 atanh((m - 1) / (m + 1)) with m in [sqrt(1/2), sqrt(2)).
[[nodiscard]] inline double fast_log(double x) noexcept {
  if (!(x >= 0x1.0p-1022)) return -745.0;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<std::int64_t>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double p = 1.0 / 21.0;
  p = p * s2 + 1.0 / 19.0;
  p = p * s2 + 1.0 / 17.0;
  p = p * s2 + 1.0 / 15.0;
  p = p * s2 + 1.0 / 13.0;
  p = p * s2 + 1.0 / 11.0;
  p = p * s2 + 1.0 / 9.0;
  p = p * s2 + 1.0 / 7.0;
  p = p * s2 + 1.0 / 5.0;
  p = p * s2 + 1.0 / 3.0;
  p = p * s2 + 1.0;
  return 2.0 * s * p + static_cast<double>(exponent) * 0.6931471805599453;
}

inline constexpr double kInvSqrtTwoPi = 0.3989422804014327;

/// Density of a normal distribution, `off` from its mean.
[[nodiscard]] inline double gaussian(double off, double sigma) noexcept {
  const double x = off / sigma;
  return kInvSqrtTwoPi / sigma * fast_exp(-0.5 * x * x);
}

/// `density` to the power of `share`, 0 ... 1: what evidence weighs of which only a share is new.
[[nodiscard]] inline double tempered(double density, double share) noexcept {
  return share < 1.0 ? fast_exp(share * fast_log(density)) : density;
}

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine to 1e-15 for |x| <= 100 (the callers keep angles wrapped). Reduction by quarter turns, then Taylor
/// series on |r| <= pi/4.
[[nodiscard]] inline SinCos fast_sincos(double x) noexcept {
  const double n = std::floor(x * (2.0 / kPi) + 0.5);
  const double r = (x - n * 1.5707963267341256) - n * 6.077100506506192e-11;
  const double r2 = r * r;
  double s = -1.0 / 1307674368000.0;
  s = s * r2 + 1.0 / 6227020800.0;
  s = s * r2 - 1.0 / 39916800.0;
  s = s * r2 + 1.0 / 362880.0;
  s = s * r2 - 1.0 / 5040.0;
  s = s * r2 + 1.0 / 120.0;
  s = s * r2 - 1.0 / 6.0;
  s = r + r * r2 * s;
  double c = 1.0 / 20922789888000.0;
  c = c * r2 - 1.0 / 87178291200.0;
  c = c * r2 + 1.0 / 479001600.0;
  c = c * r2 - 1.0 / 3628800.0;
  c = c * r2 + 1.0 / 40320.0;
  c = c * r2 - 1.0 / 720.0;
  c = c * r2 + 1.0 / 24.0;
  c = c * r2 - 0.5;
  c = 1.0 + c * r2;
  switch (static_cast<std::int64_t>(n) & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

/// `radians`, at most a few turns away, brought into [-pi, pi].
[[nodiscard]] inline double wrap_near(double radians) noexcept {
  return radians - kTwoPi * std::floor(radians * (1.0 / kTwoPi) + 0.5);
}

/// A bell-shaped variate of mean 0, variance 1 and bounded support (+-3.46), from one draw: the sum of four uniform
/// ones (Irwin and Hall). Process noise wants speed here, not tails.
[[nodiscard]] inline double cheap_normal(Random& random) noexcept {
  const std::uint64_t bits = random.next();
  const auto sum =
      static_cast<double>((bits & 0xffff) + ((bits >> 16) & 0xffff) + ((bits >> 32) & 0xffff) + (bits >> 48));
  return (sum - 2.0 * 65535.0) * (1.7320508075688772 / 65536.0);
}

}  // namespace echoway::tracker
