#include "tracker/level_belief.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::tracker {
namespace {

constexpr double kMemory = 30.0;   // Seconds.
constexpr double kLeast = 0.001;

}  // namespace

LevelBelief::LevelBelief(const Building& building) {
  std::vector<int> levels;
  for (const Room& room : building.rooms) {
    const auto known = std::find(levels.begin(), levels.end(), room.level);
    level_of_.push_back(static_cast<std::size_t>(known - levels.begin()));
    if (known == levels.end()) levels.push_back(room.level);
  }
  probability_.assign(levels.size(), 1.0 / static_cast<double>(std::max<std::size_t>(levels.size(), 1)));
  now_ = probability_;
}

double& LevelBelief::share_of(RoomIndex room, std::vector<double>& shares) const noexcept {
  return shares[level_of_[static_cast<std::size_t>(room)]];
}

void LevelBelief::begin_in(RoomIndex room) noexcept {
  std::fill(probability_.begin(), probability_.end(), 0.0);
  share_of(room, probability_) = 1.0;
}

void LevelBelief::observe(std::span<const Particle> particles, const LevelLinks& links, double seconds) noexcept {
  std::fill(now_.begin(), now_.end(), 0.0);
  for (const Particle& p : particles) {
    const RoomIndex room = p.gait == Gait::away ? links.landing(p, 0).room : p.room;
    share_of(room, now_) += p.weight;
  }
  const double gain = 1.0 - std::exp(-std::max(seconds, 0.0) / kMemory);
  for (std::size_t i = 0; i < now_.size(); ++i) probability_[i] += gain * (now_[i] - probability_[i]);
}

double LevelBelief::log_probability(RoomIndex room) const noexcept {
  return std::log(std::max(kLeast, probability_[level_of_[static_cast<std::size_t>(room)]]));
}

}  // namespace echoway::tracker
