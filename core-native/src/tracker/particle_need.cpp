#include "tracker/particle_need.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {

constexpr std::size_t kParticlesPerCell = 14;     // While several places are possible.
constexpr std::size_t kSettledCells = 10;         // A belief this narrow takes the tracking number of particles.
constexpr std::size_t kDoubtParticles = 80;       // At least so many more for each of three steps of doubt.
constexpr std::size_t kDeafParticles = 400;       // In silence more particles would learn no more.
constexpr std::size_t kAwayParticles = 800;       // Few of them arrive at the right moment and facing the right way.

}  // namespace

std::size_t particles_needed(const ParticleNeed& need, std::size_t capacity) noexcept {
  std::size_t needed = need.settled;
  if (need.away) needed = std::max(needed, kAwayParticles);
  if (need.cells > kSettledCells) needed = std::max(needed, kParticlesPerCell * need.cells);
  const std::size_t step = std::max(need.settled, kDoubtParticles);
  const double more = (need.doubt - 1.0) * static_cast<double>(step);
  needed = std::max(needed, need.settled + static_cast<std::size_t>(more));
  if (need.silent && !need.away) needed = std::min(needed, kDeafParticles);
  return std::min(needed, capacity);
}

}  // namespace echoway::tracker
