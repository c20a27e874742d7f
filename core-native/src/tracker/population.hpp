#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "echoway/random.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// A weighted set of particles in memory reserved once, in modes: places that lie apart, whose particles stand side by
/// side. Until it is resampled by modes, all of it is one.
class Population {
 public:
  static constexpr std::size_t kMostModes = 16;

  explicit Population(std::size_t capacity);

  [[nodiscard]] std::span<Particle> particles() noexcept { return {particles_.data(), count_}; }
  [[nodiscard]] std::span<const Particle> particles() const noexcept { return {particles_.data(), count_}; }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] std::size_t capacity() const noexcept { return particles_.size(); }
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }

  void clear() noexcept { count_ = mode_count_ = 0; }
  /// Ignored when full. REQUIRES: not resampled by modes since it was empty.
  void push(const Particle& particle) noexcept;
  /// Each becomes what the other was, in its own memory; who has not room for all of it gets as many drawn from it, as
  /// one place. REQUIRES: both normalized, or empty.
  void exchange(Population& other, Random& random) noexcept;
  /// Becomes like `other`, which is normalized; resampled to what there is room for when that has more particles.
  void copy(const Population& other, Random& random) noexcept;

  /// Makes the weights add up to 1 (all equal when they have vanished) and returns what they added up to.
  double normalize() noexcept;
  /// 1 / sum of squared weights. REQUIRES: normalized.
  [[nodiscard]] double effective_size() const noexcept;
  /// Least effective size of a mode, as a share of its particles. REQUIRES: not empty.
  [[nodiscard]] double least_effective_share() const noexcept;
  /// Particles of the heaviest mode.
  [[nodiscard]] std::size_t main_size() const noexcept;
  /// Number of cells of half a metre and 20 degrees that hold a particle of noticeable weight: how spread the belief is
  /// (Fox 2003, KLD sampling).
  [[nodiscard]] std::size_t occupied_cells() noexcept;
  /// Moves every particle's gyroscope bias towards `bias`, measured with `sigma` (an ensemble Kalman update with
  /// perturbed observations: Burgers, van Leeuwen and Evensen 1998).
  void observe_gyro_bias(double bias, double sigma, Random& random) noexcept;
  /// Systematic resampling (Kitagawa 1996) to `target` particles of equal weight.
  void resample(std::size_t target, Random& random) noexcept;
  /// The same for each mode by itself: `mode_of` says per particle which it belongs to, `targets` per mode how many it
  /// shall have, of equal weight and together of the mode's. Modes without a particle to come are left out.
  /// REQUIRES: at most kMostModes.
  void resample(std::span<const std::uint8_t> mode_of, std::span<const std::size_t> targets, Random& random) noexcept;

  /// Lets only `share` of what the weights have learnt since weigh_modes() count between modes; within each, all does.
  void weigh_modes() noexcept;
  void temper_modes(double share) noexcept;

 private:
  /// Systematic resampling of `from`, whose weights add up to 1, to as many particles as `out` takes.
  static void draw(std::span<const Particle> from, std::span<Particle> out, Random& random) noexcept;

  struct Mode {
    std::size_t begin = 0, end = 0;
    double weight = 0.0;                  ///< When it was weighed last.
  };
  [[nodiscard]] std::span<const Mode> modes() const noexcept { return {modes_.data(), mode_count_}; }
  [[nodiscard]] double weight_of(const Mode& mode) const noexcept;
  [[nodiscard]] std::size_t draw_mode(std::span<const std::uint8_t> mode_of, std::size_t mode, std::size_t target,
                                      std::span<Particle> out, Random& random) const noexcept;

  std::vector<Particle> particles_;
  std::vector<Particle> scratch_;
  std::size_t count_ = 0;
  std::array<Mode, kMostModes> modes_{};
  std::size_t mode_count_ = 0;            ///< 0: one of all particles.
  std::vector<std::uint64_t> table_;      ///< Open-addressing set of occupied cells.
};

}  // namespace echoway::tracker
