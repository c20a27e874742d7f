#include "tracker/population.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kCellMetres = 0.5;
constexpr double kCellRadians = degrees(20.0);
constexpr std::uint64_t kFree = ~std::uint64_t{0};
constexpr double kFlat = 0.7;   // Power of the weights by which particles of a mode are drawn.

std::uint64_t cell_key(const Particle& p) noexcept {
  const auto x = static_cast<std::int64_t>(std::floor(p.position.x / kCellMetres));
  const auto y = static_cast<std::int64_t>(std::floor(p.position.y / kCellMetres));
  const auto h = static_cast<std::int64_t>(std::floor((p.heading + kPi) / kCellRadians));
  std::uint64_t key = static_cast<std::uint64_t>(p.room) * 0x9e3779b97f4a7c15ULL;
  key = (key ^ static_cast<std::uint64_t>(x)) * 0xbf58476d1ce4e5b9ULL;
  key = (key ^ (key >> 29) ^ static_cast<std::uint64_t>(y)) * 0x94d049bb133111ebULL;
  key = (key ^ (key >> 31) ^ static_cast<std::uint64_t>(h)) * 0x9e3779b97f4a7c15ULL;
  return key == kFree ? 0 : key;
}

// By how much a particle of this weight is drawn.
double pull(double weight) noexcept { return tempered(weight, kFlat); }

std::size_t slots_for(std::size_t particles) noexcept {
  return std::bit_ceil(std::max<std::size_t>(2 * particles, 64));
}

}  // namespace

Population::Population(std::size_t capacity)
    : particles_(capacity), scratch_(capacity), table_(slots_for(capacity), kFree) {}

void Population::push(const Particle& particle) noexcept {
  if (count_ < particles_.size()) particles_[count_++] = particle;
}

void Population::exchange(Population& other, Random& random) noexcept {
  if (count_ > other.capacity()) resample(other.capacity(), random);
  if (other.count_ > capacity()) other.resample(capacity(), random);
  const auto most = static_cast<std::ptrdiff_t>(std::max(count_, other.count_));
  std::swap_ranges(particles_.begin(), particles_.begin() + most, other.particles_.begin());
  std::swap(count_, other.count_);
  std::swap(modes_, other.modes_);
  std::swap(mode_count_, other.mode_count_);
}

void Population::copy(const Population& other, Random& random) noexcept {
  const bool fits = other.count_ <= particles_.size();
  count_ = std::min(other.count_, particles_.size());
  mode_count_ = fits ? other.mode_count_ : 0;
  modes_ = other.modes_;
  if (fits) {
    std::ranges::copy(other.particles(), particles_.begin());
  } else {
    draw(other.particles(), particles(), random);
  }
}

double Population::normalize() noexcept {
  double sum = 0.0;
  for (const Particle& p : particles()) sum += p.weight;
  if (!(sum > 0.0) || !std::isfinite(sum)) {
    for (Particle& p : particles()) p.weight = 1.0 / static_cast<double>(count_);
    return 0.0;
  }
  const double scale = 1.0 / sum;
  for (Particle& p : particles()) p.weight *= scale;
  return sum;
}

double Population::effective_size() const noexcept {
  double squares = 0.0;
  for (const Particle& p : particles()) squares += p.weight * p.weight;
  return squares > 0.0 ? 1.0 / squares : 0.0;
}

double Population::weight_of(const Mode& mode) const noexcept {
  double sum = 0.0;
  for (std::size_t i = mode.begin; i < mode.end; ++i) sum += particles_[i].weight;
  return sum;
}

double Population::least_effective_share() const noexcept {
  if (mode_count_ == 0) return effective_size() / static_cast<double>(count_);
  double least = 1.0;
  for (const Mode& mode : modes()) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = mode.begin; i < mode.end; ++i) {
      sum += particles_[i].weight;
      squares += particles_[i].weight * particles_[i].weight;
    }
    if (squares > 0.0) least = std::min(least, sum * sum / (squares * static_cast<double>(mode.end - mode.begin)));
  }
  return least;
}

std::size_t Population::main_size() const noexcept {
  if (mode_count_ == 0) return count_;
  const auto heaviest = std::ranges::max_element(modes(), {}, [&](const Mode& mode) { return weight_of(mode); });
  return heaviest->end - heaviest->begin;
}

void Population::weigh_modes() noexcept {
  if (mode_count_ < 2) return;   // Nothing that temper_modes() could change.
  for (std::size_t m = 0; m < mode_count_; ++m) modes_[m].weight = weight_of(modes_[m]);
}

void Population::temper_modes(double share) noexcept {
  if (mode_count_ < 2) return;
  for (const Mode& mode : modes()) {
    const double weight = weight_of(mode);
    if (!(weight > 0.0) || !(mode.weight > 0.0)) continue;
    const double back = fast_exp((share - 1.0) * fast_log(weight / mode.weight));
    for (std::size_t i = mode.begin; i < mode.end; ++i) particles_[i].weight *= back;
  }
}

std::size_t Population::occupied_cells() noexcept {
  const std::size_t slots = slots_for(count_);   // Few particles need no large table.
  std::fill_n(table_.begin(), slots, kFree);
  const std::size_t mask = slots - 1;
  const double least = 0.05 / static_cast<double>(std::max<std::size_t>(count_, 1));
  std::size_t occupied = 0;
  for (const Particle& p : particles()) {
    if (p.weight < least) continue;
    const std::uint64_t key = cell_key(p);
    std::size_t at = static_cast<std::size_t>(key >> 20) & mask;
    while (table_[at] != kFree && table_[at] != key) at = (at + 1) & mask;
    if (table_[at] == key) continue;
    table_[at] = key;
    ++occupied;
  }
  return occupied;
}

void Population::observe_gyro_bias(double bias, double sigma, Random& random) noexcept {
  double mean = 0.0, square = 0.0;
  for (const Particle& p : particles()) {
    mean += p.weight * p.gyro_bias;
    square += p.weight * p.gyro_bias * p.gyro_bias;
  }
  const double variance = std::max(square - mean * mean, 0.0);
  const double gain = variance / (variance + sigma * sigma);
  for (Particle& p : particles()) p.gyro_bias += gain * (bias + sigma * cheap_normal(random) - p.gyro_bias);
}

void Population::resample(std::size_t target, Random& random) noexcept {
  if (count_ == 0) return;
  target = std::clamp<std::size_t>(target, 1, particles_.size());
  draw(particles(), {scratch_.data(), target}, random);
  particles_.swap(scratch_);
  count_ = target;
  mode_count_ = 0;
}

void Population::draw(std::span<const Particle> from, std::span<Particle> out, Random& random) noexcept {
  const double step = 1.0 / static_cast<double>(out.size());
  double at = random.uniform() * step;
  double reached = from[0].weight;
  std::size_t i = 0;
  for (Particle& p : out) {
    while (reached < at && i + 1 < from.size()) reached += from[++i].weight;
    p = from[i];
    p.weight = step;
    at += step;
  }
}

void Population::resample(std::span<const std::uint8_t> mode_of, std::span<const std::size_t> targets,
                          Random& random) noexcept {
  std::size_t made = 0;
  mode_count_ = 0;
  for (std::size_t m = 0; m < targets.size(); ++m) {
    const std::size_t begin = made;
    const std::size_t left = particles_.size() - made;
    made += draw_mode(mode_of, m, std::min(targets[m], left), {scratch_.data() + made, left}, random);
    if (made > begin) modes_[mode_count_++] = {begin, made, 0.0};
  }
  if (made == 0) return;
  particles_.swap(scratch_);
  count_ = made;
  normalize();
}

// Systematic resampling of the particles of one mode to the front of `out`; returns how many. They are drawn by flatter
// weights than their own, and keep the rest of those (Liu, Chen and Logvinenko 2001): who is likelier by a chance echo
// leaves some of the others, and of few particles more than one or two see a start or a stop.
std::size_t Population::draw_mode(std::span<const std::uint8_t> mode_of, std::size_t mode, std::size_t target,
                                  std::span<Particle> out, Random& random) const noexcept {
  if (target == 0) return 0;
  double weight = 0.0, pulls = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (mode_of[i] != mode) continue;
    weight += particles_[i].weight;
    pulls += pull(particles_[i].weight);
  }
  if (!(weight > 0.0)) return 0;
  const double step = pulls / static_cast<double>(target);
  double at = random.uniform() * step;
  double reached = 0.0, drawn = 0.0;
  std::size_t made = 0, last = 0;
  const auto take = [&](const Particle& p, double pulled) {
    out[made] = p;
    drawn += out[made++].weight = p.weight / pulled;
  };
  for (std::size_t i = 0; i < count_; ++i) {
    if (mode_of[i] != mode) continue;
    last = i;
    const double pulled = pull(particles_[i].weight);
    reached += pulled;
    for (; made < target && at < reached; at += step) take(particles_[i], pulled);
  }
  // Rounding may leave the last one's share out.
  while (made < target) take(particles_[last], pull(particles_[last].weight));
  for (Particle& p : out.first(made)) p.weight *= weight / drawn;
  return made;
}

}  // namespace echoway::tracker
