#pragma once

#include <cstddef>

namespace echoway::tracker {

/// What tells how many particles a belief needs.
struct ParticleNeed {
  std::size_t settled = 0;    ///< Particles that are enough for one place that fits.
  std::size_t cells = 1;      ///< Cells of places and headings that are possible (Population::occupied_cells()).
  double doubt = 1.0;         ///< FitMonitor::doubt(): 1 ... 4.
  bool away = false;          ///< The wearer may be on stairs or in an elevator.
  bool silent = false;        ///< Nothing has been heard lately.
};

/// How many particles the belief needs: more where it may be many places, where the echoes do not fit and where the
/// wearer may be away, fewer where more would learn no more; `capacity` at most.
[[nodiscard]] std::size_t particles_needed(const ParticleNeed& need, std::size_t capacity) noexcept;

}  // namespace echoway::tracker
