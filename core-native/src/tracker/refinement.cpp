#include "tracker/refinement.hpp"

#include <algorithm>
#include <array>

#include "tracker/elementary.hpp"
#include "tracker/floor.hpp"

namespace echoway::tracker {
namespace {

constexpr std::uint64_t kRound = 5;               // Firings between looks at the weights.
constexpr std::size_t kParticlesPerCell = 14;
constexpr std::size_t kFewest = 400;
constexpr double kSpread = degrees(1.0);          // Radians by which copies of a particle part.

// A search starts from cells of places: a reading that is not new weighs less, but narrows them all the same.
Shot shot_of_past(const Record& record, const BeltConfig& belt) noexcept {
  const SinCos b = fast_sincos(belt.bearing(record.sensor));
  Shot shot = shot_of(record, belt, {b.cos, b.sin});
  shot.novelty = 1.0;
  return shot;
}

// Replays one firing; no `stride` when the way since the firing before does not count.
void replay(Particle& p, const Record& record, const Shot& shot, const Stride* stride, double share, const SearchTools& tools,
            Random& random) noexcept {
  if (stride != nullptr) stride->advance(p, random);
  if (record.trust > 0.0) p.weight *= tempered(assimilate(p, shot, tools.model, tools.scene).density, share * record.novelty);
  p.weight *= std::max(1e-9, settle_on_floor(p, tools.scene));
}

}  // namespace

double share_of(std::uint64_t firing, std::uint64_t first, const BeltConfig& belt) noexcept {
  constexpr double kFirst = 0.75;
  constexpr double kAgain = 0.5;
  return firing < first + static_cast<std::uint64_t>(belt.sensors) ? kFirst : kAgain;
}

void Refinement::begin(std::uint64_t first) noexcept {
  population_.clear();
  first_ = reached_ = round_end_ = first;
  cursor_ = 0;
  log_evidence_ = 0.0;
}

bool Refinement::work(const SearchTools& tools, Random& random, std::size_t budget) noexcept {
  replayed_ = 0;
  while (replayed_ < budget) {
    if (cursor_ == 0) {
      if (reached_ == tools.history.end()) return true;
      round_end_ = std::min(reached_ + kRound, tools.history.end());
    }
    std::array<Shot, kRound> shots;
    std::array<Stride, kRound> strides;
    for (std::uint64_t n = reached_; n < round_end_; ++n) {
      const auto i = static_cast<std::size_t>(n - reached_);
      shots[i] = shot_of_past(tools.history[n], tools.belt);
      strides[i] = Stride(tools.history[n].interval, tools.motion, tools.pace);
    }
    const auto particles = population_.particles();
    for (; cursor_ < particles.size() && replayed_ < budget; ++cursor_) {
      for (std::uint64_t n = reached_; n < round_end_; ++n, ++replayed_) {
        const auto i = static_cast<std::size_t>(n - reached_);
        const Stride* stride = n != first_ ? &strides[i] : nullptr;
        replay(particles[cursor_], tools.history[n], shots[i], stride, share_of(n, first_, tools.belt), tools, random);
      }
    }
    if (cursor_ < particles.size()) return false;
    close_round(random);
  }
  return reached_ == tools.history.end();
}

// Particles where the first firings point to make room for what the later ones need.
void Refinement::close_round(Random& random) noexcept {
  reached_ = round_end_;
  cursor_ = 0;
  log_evidence_ += fast_log(population_.normalize());
  const double n = static_cast<double>(population_.size());
  if (population_.effective_size() > 0.5 * n) return;
  population_.resample(std::clamp(kParticlesPerCell * population_.occupied_cells(), kFewest, population_.size()), random);
  for (Particle& p : population_.particles()) p.heading = wrap_near(p.heading + kSpread * cheap_normal(random));
}

}  // namespace echoway::tracker
