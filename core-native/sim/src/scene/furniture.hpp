#pragma once

#include <vector>

#include "scene/room_scene.hpp"

namespace echoway::sim {

/// Puts cupboards, desks and posts into a room, clear of doors and of the places in `kept_free`.
void add_furniture(const Room& room, const std::vector<Doorway>& doorways, const World& world,
                   const std::vector<Vec2>& kept_free, Random& random, RoomScene& scene);

}  // namespace echoway::sim
