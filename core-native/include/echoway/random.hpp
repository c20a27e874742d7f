#pragma once

#include <cmath>
#include <cstdint>

#include "echoway/units.hpp"

namespace echoway {

/// A seeded generator whose sequence is the same with every compiler and standard library: SplitMix64 (Steele, Lea and
/// Flood 2014). The standard library's distributions are not used because their results differ between libraries.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) noexcept : state_(seed) {}

  constexpr std::uint64_t next() noexcept {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1), 53 bits.
  constexpr double uniform() noexcept { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  constexpr double uniform(double low, double high) noexcept { return low + (high - low) * uniform(); }

  /// Standard normal (Box and Muller 1958).
  double normal() noexcept {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(kTwoPi * uniform());
  }
  double normal(double mean, double sigma) noexcept { return mean + sigma * normal(); }

  /// An independent generator for a sub-task.
  constexpr Random split() noexcept { return Random(next()); }

 private:
  std::uint64_t state_;
};

}  // namespace echoway
