#include "tracker/modes.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {

// The nearest place of the summary, or their number when none is near.
int Modes::place_of(const Particle& p, const Summary& summary, const Building& building) const noexcept {
  const Room& room = building.room(p.room);
  const Vec2 at = room.frame.transform(p.position);
  const double heading = p.heading + room.frame.heading;
  double nearest2 = parameters_.radius * parameters_.radius;
  int place = summary.count;
  for (int i = 0; i < summary.count; ++i) {
    const Hypothesis& h = summary.hypotheses[static_cast<std::size_t>(i)];
    const Room& its = building.room(h.room);
    if (its.level != room.level) continue;
    const double d2 = squared_norm(at - its.frame.transform(h.pose.position));
    if (d2 >= nearest2 || std::abs(wrap_near(heading - h.pose.heading - its.frame.heading)) >= parameters_.angle) continue;
    nearest2 = d2;
    place = i;
  }
  return place;
}

void Modes::resample(Population& population, const Summary& summary, const Building& building, std::size_t target, bool blind,
                     Random& random) noexcept {
  const auto particles = population.particles();
  std::array<double, kMost> weights{};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    of_[i] = static_cast<std::uint8_t>(place_of(particles[i], summary, building));
    weights[of_[i]] += particles[i].weight;
  }
  const std::size_t fewest = blind ? parameters_.fewest_blind : parameters_.fewest;
  std::array<std::size_t, kMost> targets{};
  for (std::size_t place = 0; place < kMost; ++place) {
    targets[place] = static_cast<std::size_t>(std::lround(static_cast<double>(target) * weights[place]));
    const bool possible = static_cast<int>(place) < summary.count && weights[place] > parameters_.least;
    if (possible) targets[place] = std::max(targets[place], fewest);
  }
  population.resample(std::span(of_).first(particles.size()), targets, random);
}

}  // namespace echoway::tracker
