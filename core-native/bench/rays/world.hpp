#pragma once

#include <vector>

#include "rays/things.hpp"

namespace echoway::rays {

/// A second world to try the tracker in, written apart from both the tracker and the simulator (sim/), and as plain as
/// that is detailed: no waves, no amplitudes. Whatever lies in the beam and in sight answers with a chance of its own,
/// by its kind, its angle off the axis and its distance; the nearest that does is what is read. What this world has in
/// common with the simulator is only what any such world must have: planes, corners, edges, the beam, one per cent of
/// noise.
class World {
 public:
  /// `things` of one level; everything else is drawn from `random`.
  World(Things things, Random random);

  /// What a sensor at `eye` that faces along `axis` (unit) reads, metres, `seconds` after the one before; or
  /// Firing::kNoEcho.
  [[nodiscard]] double fire(Vec2 eye, Vec2 axis, double seconds);

 private:
  struct Answer {
    double range = 0.0;
    double chance = 0.0;
  };
  void move_people(double seconds);
  void ask_planes(Vec2 eye, Vec2 axis);
  void ask_points(Vec2 eye, Vec2 axis);
  void ask_benches(Vec2 eye, Vec2 axis);
  void ask_discs(Vec2 eye, Vec2 axis, const std::vector<Disc>& discs, double chance);
  void ask_by_way_of_walls(Vec2 eye, Vec2 axis);
  void add(double range, double chance);
  /// Chance that something in this direction (not unit) lies in the beam: 1/2 at its edge.
  [[nodiscard]] double beam(Vec2 axis, Vec2 way) const noexcept;
  [[nodiscard]] double nearest_that_answers();

  Things things_;
  Random random_;
  double beam_;                          ///< Half of the beam's angle, radians, and
  double beam_softness_;                 ///< how soft its edge is.
  double unheard_;                       ///< Share of firings of which nothing comes back,
  double ghost_;                         ///< of readings out of nowhere
  double arm_;                           ///< and of arms.
  double scale_;                         ///< Reads longer by this share: air that is not as warm as taken for granted.
  double edge_reach_;                    ///< Metres up to which edges answer.
  double second_order_;                  ///< Chance that a wall answers by way of another one.
  std::vector<Vec2> velocities_;         ///< Of the people, m/s.
  std::vector<Answer> answers_;          ///< To the firing at hand.
};

}  // namespace echoway::rays
