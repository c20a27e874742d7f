#pragma once

#include "scene/scene.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// Whether somebody may stand there: on the room's floor, and not so near to a wall that a body would be in it even if
/// the position were a little wrong. Nobody stands where it is not finite.
[[nodiscard]] bool can_stand(const scene::RoomScene& room, Vec2 position) noexcept;

/// Keeps a particle's room in step with its position: through a door it changes room (and frame), in the middle of the
/// wall; walls are not walked through. Returns a factor for its weight, 1 on the floor, less the farther its mean
/// stands outside, in terms of its own uncertainty.
[[nodiscard]] double settle_on_floor(Particle& particle, scene::Scene& scene) noexcept;

}  // namespace echoway::tracker
