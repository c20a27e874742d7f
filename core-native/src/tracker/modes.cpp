#include "tracker/modes.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {

// The nearest of the first `count` places, or their number when none is near.
std::size_t Modes::nearest(const Placed& at, std::size_t count) const noexcept {
  double nearest2 = parameters_.radius * parameters_.radius;
  std::size_t found = count;
  for (std::size_t i = 0; i < count; ++i) {
    const Placed& place = places_[i];
    if (place.level != at.level) continue;
    const double d2 = squared_norm(at.position - place.position);
    if (d2 >= nearest2 || std::abs(wrap_near(at.heading - place.heading)) >= parameters_.angle) continue;
    nearest2 = d2;
    found = i;
  }
  return found;
}

void Modes::resample(Population& population, const Summary& summary, const Building& building, std::size_t target,
                     bool blind, Random& random) noexcept {
  const auto particles = population.particles();
  const auto count = static_cast<std::size_t>(summary.count);
  for (std::size_t i = 0; i < count; ++i) {
    const Hypothesis& h = summary.hypotheses[i];
    places_[i] = place(h.pose.position, h.pose.heading, RoomFrame(building, h.room));
  }
  RoomFrame frame;
  std::array<double, kMost> weights{};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles[i].room != frame.room) frame = RoomFrame(building, particles[i].room);
    of_[i] = static_cast<std::uint8_t>(nearest(place(particles[i], frame), count));
    weights[of_[i]] += particles[i].weight;
  }
  const std::size_t fewest = blind ? parameters_.fewest_blind : parameters_.fewest;
  std::array<std::size_t, kMost> targets{};
  for (std::size_t mode = 0; mode < kMost; ++mode) {
    targets[mode] = static_cast<std::size_t>(std::lround(static_cast<double>(target) * weights[mode]));
    const bool possible = mode < count && weights[mode] > parameters_.least;
    if (possible) targets[mode] = std::max(targets[mode], fewest);
  }
  population.resample(std::span(of_).first(particles.size()), targets, random);
}

}  // namespace echoway::tracker
