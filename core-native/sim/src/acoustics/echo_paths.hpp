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
};

/// What stands close to the wearer and moves: arms, passers-by. Answers like a post and blocks what is behind.
struct Obstacle {
  Disc disc{};
  double reflectivity = 1.0;
};

/// All the paths by which sound comes back: planes, corners, edges and posts directly and, with mirror_paths, by way of
/// a plane that is not met squarely.
void find_arrivals(const View& view, const Receiver& receiver, const World& world, const Sensor& sensor,
                   const std::vector<Obstacle>& obstacles, double max_path_m, std::vector<Arrival>& arrivals);

}  // namespace echoway::sim
