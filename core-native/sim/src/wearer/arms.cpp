#include "wearer/arms.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::sim {

void add_arms(const Moment& moment, double share, std::vector<Obstacle>& obstacles) {
  constexpr double kAside = 0.36;  // From the axis to a hanging forearm, metres.
  constexpr double kThick = 0.045;
  constexpr double kSwingPerSpeed = 0.35;  // Metres for each metre a second.
  constexpr double kSkin = 0.5;            // Reflectivity of skin and cloth.
  constexpr double kHabit = 23.0;          // Seconds in which hands go up and down once.
  const double habit = moment.time_s / kHabit - std::floor(moment.time_s / kHabit);
  if (habit >= share) return;
  const double swing = kSwingPerSpeed * std::min(1.0, moment.speed) * std::sin(moment.stride);
  for (const double side : {-1.0, 1.0}) {
    obstacles.push_back({moment.heard_from().transform({side * swing - 0.02, side * kAside}), kThick, kSkin});
  }
}

}  // namespace echoway::sim
