#pragma once

#include <span>
#include <vector>

#include "echoway/building/building.hpp"
#include "tracker/level_links.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// Which level the wearer has been on of late. Levels are often alike, and a search that hears nothing of what parts
/// them would find the wearer on any; but nobody changes levels without stairs or an elevator.
class LevelBelief {
 public:
  explicit LevelBelief(const Building& building);

  /// The wearer starts on the level of this room.
  void begin_in(RoomIndex room) noexcept;
  /// What a belief of weights that add up to 1 said for so long. Who is away counts where the link leads.
  void observe(std::span<const Particle> particles, const LevelLinks& links, double seconds) noexcept;
  /// Never so low that echoes could not prove it wrong. At most 0.
  [[nodiscard]] double log_probability(RoomIndex room) const noexcept;

 private:
  [[nodiscard]] double& share_of(RoomIndex room, std::vector<double>& shares) const noexcept;

  std::vector<std::size_t> level_of_;   ///< Per room, numbered from 0.
  std::vector<double> probability_;     ///< Per level; they add up to 1.
  std::vector<double> now_;
};

}  // namespace echoway::tracker
