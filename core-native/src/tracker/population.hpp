#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoway/random.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// A weighted set of particles in memory reserved once.
class Population {
 public:
  explicit Population(std::size_t capacity);

  [[nodiscard]] std::span<Particle> particles() noexcept { return {particles_.data(), count_}; }
  [[nodiscard]] std::span<const Particle> particles() const noexcept { return {particles_.data(), count_}; }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] std::size_t capacity() const noexcept { return particles_.size(); }
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }

  void clear() noexcept { count_ = 0; }
  void push(const Particle& particle) noexcept;   ///< Ignored when full.
  void swap(Population& other) noexcept;

  /// Makes the weights add up to 1 (all equal when they have vanished) and returns what they added up to.
  double normalize() noexcept;
  /// 1 / sum of squared weights. REQUIRES: normalized.
  [[nodiscard]] double effective_size() const noexcept;
  /// Number of cells of half a metre and 20 degrees that hold a particle of noticeable weight: how spread the belief is
  /// (Fox 2003, KLD sampling).
  [[nodiscard]] std::size_t occupied_cells() noexcept;
  /// Moves every particle's gyroscope bias towards `bias`, measured with `sigma` (an ensemble Kalman update with perturbed
  /// observations: Burgers, van Leeuwen and Evensen 1998).
  void observe_gyro_bias(double bias, double sigma, Random& random) noexcept;
  /// Systematic resampling (Kitagawa 1996) to `target` particles of equal weight.
  void resample(std::size_t target, Random& random) noexcept;

 private:
  std::vector<Particle> particles_;
  std::vector<Particle> scratch_;
  std::size_t count_ = 0;
  std::vector<std::uint64_t> table_;      ///< Open-addressing set of occupied cells.
};

}  // namespace echoway::tracker
