#include "tracker/between_levels.hpp"

namespace echoway::tracker {
namespace {

/// Echoes as likely at any distance up to `reach` metres.
struct Within {
  double share;
  double reach;

  [[nodiscard]] double density(double range) const noexcept { return range < reach ? share / reach : 0.0; }
};

constexpr double kAnyRange = 12.0;             // Metres: farther than most belts hear.

// Cabins measure 1.1 by 1.4 m most often, 2.0 by 1.4 m at most (EN 81-70). Their steel walls answer straight on, and by
// way of one another two or three times as far.
constexpr double kCabinAnswers = 0.65;
constexpr Within kCabinWalls{0.63, 1.6};
constexpr Within kCabinLate{0.34, 4.0};
constexpr double kCabinNowhere = 0.03 / kAnyRange;

// A flight is 1.0 to 1.2 m wide (DIN 18065, BS 5395-1), and two of them with their landings fill a well of some 2.5 by
// 4.5 m: beside the wearer are a wall and balusters, before and behind risers or the far wall.
constexpr Within kFlight{0.54, 2.0};
constexpr Within kWell{0.36, 4.5};
constexpr double kStairsNowhere = 0.10 / kAnyRange;

}  // namespace

double in_cabin(const Shot& shot) noexcept {
  if (!shot.echo) return 1.0 - kCabinAnswers;
  const double r = shot.range;
  return kCabinAnswers * (kCabinWalls.density(r) + kCabinLate.density(r) + kCabinNowhere);
}

double on_stairs(const Shot& shot, double echo_share) noexcept {
  if (!shot.echo) return 1.0 - echo_share;
  const double r = shot.range;
  return echo_share * (kFlight.density(r) + kWell.density(r) + kStairsNowhere);
}

}  // namespace echoway::tracker
