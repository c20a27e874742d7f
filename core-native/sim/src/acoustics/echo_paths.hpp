#pragma once

#include <vector>

#include "acoustics/receiver.hpp"
#include "scene/view.hpp"

namespace echoway::sim {

/// The transducer when it fires, in the frame of the view.
struct Sensor {
  Vec2 face{};
  Vec2 axis{1.0, 0.0};  ///< Unit vector.
  int room = 0;         ///< Placed room in which the face is.
  Vec2 wearer{};        ///< The axis of the body that carries it, which blocks what comes round from the other side.
  double girth = 0.0;   ///< Radius of that body, metres.
};

/// Something round that moves: an arm, a passer-by. Answers like a post and blocks what is behind.
struct Obstacle {
  Vec2 centre{};
  double radius = 0.0;
  double reflectivity = 1.0;
};

/// All paths up to `max_path_m` by which sound comes back loud enough to matter (image sources, at most two planes):
/// planes, right-angled corners, edges and posts directly; by way of a plane and back the same way; round a triangle of
/// two planes, or of a plane and an edge or post.
void find_arrivals(const View& view, const Receiver& receiver, const World& world, const Sensor& sensor,
                   const std::vector<Obstacle>& obstacles, double max_path_m, std::vector<Arrival>& arrivals);

}  // namespace echoway::sim
