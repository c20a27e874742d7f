#include "tracker/panorama.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {

void Panorama::stand_at(const scene::RoomScene& room, Vec2 position) noexcept {
  room_ = &room;
  position_ = position;
  known_.fill(false);
}

const Panorama::Sight& Panorama::towards(double angle, double radius, const EchoModel& model,
                                         const scene::Cell& seen) noexcept {
  const double turns = angle * (1.0 / kTwoPi);
  const double part = turns - std::floor(turns);
  const auto at = static_cast<std::size_t>(part * kDirections + 0.5) % kDirections;
  Sight& sight = sights_[at];
  if (known_[at]) return sight;
  Particle p;
  p.position = position_;
  p.heading = wrap_near(kTwoPi * static_cast<double>(at) / kDirections);
  face_heading(p);
  Shot shot;
  shot.radius = radius;
  shot.coarse = true;
  sight.echoes = expect_from(seen, *room_, p, shot, model);
  sight.silence = 1.0;
  for (int j = 0; j < sight.echoes.count; ++j) {
    sight.silence *= 1.0 - sight.echoes.echo[static_cast<std::size_t>(j)].chance;
  }
  known_[at] = true;
  ++looks_;
  return sight;
}

double density_of(const Panorama::Sight& sight, bool echo, double range, const Offset& offset,
                  const EchoModel& model) noexcept {
  if (!echo) return model.silence(sight.silence);
  double survival = 1.0, survival_at_range = 1.0, explained = 0.0, furniture = 0.0;
  for (int j = 0; j < sight.echoes.count; ++j) {
    const ExpectedEcho& e = sight.echoes.echo[static_cast<std::size_t>(j)];
    const double expected = e.range + dot(e.gradient(), offset.moved);
    const double innovation = range - expected * (1.0 + offset.log_scale);
    const double along = dot(e.gradient(), offset.per_speed);
    const double variance = model.variance(e.range) + e.extra_variance + offset.variance * squared_norm(e.gradient()) +
                            offset.speed_variance * along * along + offset.log_scale_variance * e.range * e.range;
    const double innovation2 = innovation * innovation;
    if (innovation2 < kGate2 * variance) {
      explained += survival * e.chance * kInvSqrtTwoPi / std::sqrt(variance) * fast_exp(-0.5 * innovation2 / variance);
    }
    if (e.of_wall) furniture += survival * e.chance * model.furniture(-innovation);
    survival *= 1.0 - e.chance;
    if (expected < range) survival_at_range = survival;
  }
  return std::max(kLeastDensity, model.echo(explained, survival_at_range, range, furniture));
}

}  // namespace echoway::tracker
