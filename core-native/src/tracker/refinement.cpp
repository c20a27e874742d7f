#include "tracker/refinement.hpp"

#include <algorithm>
#include <array>

#include "tracker/elementary.hpp"
#include "tracker/floor.hpp"
#include "tracker/likelihood.hpp"
#include "tracker/summary.hpp"

namespace echoway::tracker {
double share_of(std::uint64_t firing, std::uint64_t first, const BeltConfig& belt) noexcept {
  constexpr double kFirst = 0.75;
  constexpr double kAgain = 0.5;
  return firing < first + static_cast<std::uint64_t>(belt.sensors) ? kFirst : kAgain;
}

namespace {

constexpr std::uint64_t kRound = 5;               // Firings between looks at the weights.
constexpr std::size_t kParticlesPerCell = 14;
constexpr std::size_t kFewest = 400;
constexpr std::size_t kFewCells = 60;             // Of a dozen places at most, once every sensor was heard twice.
constexpr double kShareBetween = 0.3;             // Of what counts, half by then, between places: as in a tracker
                                                  // with a gyroscope.
constexpr double kSpread = degrees(1.0);          // Radians by which copies of a particle part.

// A search starts from cells of places: a reading that is not new weighs less, but narrows them all the same.
Shot shot_of_past(const Record& record, const BeltConfig& belt) noexcept {
  const SinCos b = fast_sincos(belt.bearing(record.sensor));
  Shot shot = shot_of(record, belt, {b.cos, b.sin});
  shot.novelty = 1.0;
  return shot;
}

// A firing of the past, worked out once for all particles.
struct Past {
  Shot shot;
  Stride stride;             ///< Since the firing before,
  bool first = false;        ///< which does not count for the first.
  double evidence = 0.0;     ///< Share of what it says that counts.
  bool foreseen = false;
};

Past past_of(std::uint64_t firing, std::uint64_t first, bool foreseen, const SearchTools& tools) noexcept {
  const Record& record = tools.history[firing];
  const Stride stride(record.interval, tools.motion, tools.pace, record.gait);
  return {shot_of_past(record, tools.belt), stride, firing == first,
          share_of(firing, first, tools.belt) * record.novelty, foreseen};
}

void replay(Particle& p, const Past& past, const SearchTools& tools, Random& random) noexcept {
  if (!past.first) past.stride.advance(p, random);
  if (past.shot.trust > 0.0) {
    p.weight *= tempered(assimilate(p, past.shot, tools.model, tools.scene).density, past.evidence);
  }
  if (past.foreseen) p.weight *= p.foreseen;
  p.weight *= std::max(1e-9, settle_on_floor(p, tools.scene));
}

}  // namespace

void Refinement::begin(std::uint64_t first, std::uint64_t foreseen, bool modes) noexcept {
  in_modes_ = modes;
  population_.clear();
  first_ = reached_ = round_end_ = first;
  foreseen_end_ = first + foreseen;
  cursor_ = 0;
  log_evidence_ = 0.0;
}

bool Refinement::work(const SearchTools& tools, Random& random, std::size_t budget,
                      std::size_t compiled_per_replay) noexcept {
  spent_ = 0;
  while (spent_ < budget) {
    if (cursor_ == 0) {
      if (reached_ == tools.history.end()) return true;
      round_end_ = std::min(reached_ + kRound, tools.history.end());
      population_.weigh_modes();
    }
    std::array<Past, kRound> round;
    const auto firings = static_cast<std::size_t>(round_end_ - reached_);
    for (std::size_t i = 0; i < firings; ++i) {
      const std::uint64_t firing = reached_ + i;
      round[i] = past_of(firing, first_, firing < foreseen_end_, tools);
    }
    const auto particles = population_.particles();
    for (; cursor_ < particles.size() && spent_ < budget; ++cursor_) {
      const std::size_t compiled = tools.scene.compile_work();
      for (std::size_t i = 0; i < firings; ++i) replay(particles[cursor_], round[i], tools, random);
      spent_ += firings + (tools.scene.compile_work() - compiled) / compiled_per_replay;
    }
    if (cursor_ < particles.size()) return false;
    close_round(tools, random);
  }
  return reached_ == tools.history.end();
}

void Refinement::close_round(const SearchTools& tools, Random& random) noexcept {
  reached_ = round_end_;
  cursor_ = 0;
  log_evidence_ += fast_log(population_.normalize());
  population_.temper_modes(kShareBetween);
  population_.normalize();
  if (population_.least_effective_share() <= 0.5) resample(tools, random);
}

// Particles where the first firings point to make room for what the later ones need.
void Refinement::resample(const SearchTools& tools, Random& random) noexcept {
  const std::size_t cells = population_.occupied_cells();
  const std::size_t target = std::min(std::max(kParticlesPerCell * cells, kFewest), population_.size());
  const bool heard_twice = reached_ >= first_ + 2 * static_cast<std::uint64_t>(tools.belt.sensors);
  if (in_modes_ && heard_twice && cells <= kFewCells) {
    const Summary summary = summarize(population_.particles(), tools.building, SummaryParameters{});
    modes_.resample(population_, summary, tools.building, target, false, random);
  } else {
    population_.resample(target, random);
  }
  for (Particle& p : population_.particles()) p.heading = wrap_near(p.heading + kSpread * cheap_normal(random));
}

}  // namespace echoway::tracker
