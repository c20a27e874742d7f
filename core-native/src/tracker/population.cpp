#include "tracker/population.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kCellMetres = 0.5;
constexpr double kCellRadians = degrees(20.0);
constexpr std::uint64_t kFree = ~std::uint64_t{0};

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

}  // namespace

Population::Population(std::size_t capacity) : particles_(capacity), scratch_(capacity) {
  std::size_t slots = 64;
  while (slots < 2 * capacity) slots *= 2;
  table_.assign(slots, kFree);
}

void Population::push(const Particle& particle) noexcept {
  if (count_ < particles_.size()) particles_[count_++] = particle;
}

void Population::swap(Population& other) noexcept {
  particles_.swap(other.particles_);
  scratch_.swap(other.scratch_);
  table_.swap(other.table_);
  std::swap(count_, other.count_);
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

std::size_t Population::occupied_cells() noexcept {
  std::fill(table_.begin(), table_.end(), kFree);
  const std::size_t mask = table_.size() - 1;
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
  const double step = 1.0 / static_cast<double>(target);
  double at = random.uniform() * step;
  double reached = particles_[0].weight;
  std::size_t i = 0;
  for (std::size_t n = 0; n < target; ++n, at += step) {
    while (reached < at && i + 1 < count_) reached += particles_[++i].weight;
    scratch_[n] = particles_[i];
    scratch_[n].weight = step;
  }
  particles_.swap(scratch_);
  count_ = target;
}

}  // namespace echoway::tracker
