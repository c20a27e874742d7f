#pragma once

#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/random.hpp"
#include "echoway/sim/world.hpp"
#include "plan/doorway.hpp"

namespace echoway::sim {

/// A plane that reflects and blocks.
struct Panel {
  Segment at{};
  double reflectivity = 1.0;  ///< Amplitude left after a bounce.
};

/// Two panels at a right angle: sound that enters between `u` and `v` leaves the way it came.
struct Corner {
  Vec2 at{};
  Vec2 u{};  ///< Unit vectors along the panels, away from the corner.
  Vec2 v{};
  double reach_u = 0.0;  ///< How far the panels extend, metres.
  double reach_v = 0.0;
  double reflectivity = 1.0;
};

/// Something small that answers in every direction.
struct Scatterer {
  Vec2 at{};
  double radius = 0.0;  ///< Of a thin post, metres; 0 for an edge, which diffracts.
  double gain = 1.0;    ///< Amplitude above the ideal edge or post.
};

/// One room as sound meets it: walls with the door openings cut out, and what stands about. In the room's frame.
struct RoomScene {
  std::vector<Panel> panels;
  std::vector<Corner> corners;
  std::vector<Scatterer> scatterers;
  std::vector<Segment> things;  ///< Outlines of what stands about, for whoever walks into it; they answer as panels.
};

/// `kept_free`: places in the room where the wearer passes; nothing is put there.
[[nodiscard]] RoomScene build_room_scene(const Room& room, const std::vector<Doorway>& doorways, const World& world,
                                         const std::vector<Vec2>& kept_free, Random random);

/// Adds the corners and edges that the scene's panels make with each other.
void finish_scene(const World& world, RoomScene& scene);

}  // namespace echoway::sim
