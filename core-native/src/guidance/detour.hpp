#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoway/routing/free_space.hpp"
#include "guidance/route_line.hpp"

namespace echoway::guidance {

/// A point of a thing that no plan knows.
struct ThingPoint {
  Vec2 at{};
  int met = 1;  ///< How often a wearer was stopped about here, or 1 if only echoes tell of it.
};

/// The easiest way round things of which only some points are known. Nearness to a point costs more the nearer it is
/// and never everything: what is known of things is vague, and the only way may lead close past them. Where somebody
/// was stopped again it costs more each time: whatever stands there, another way has to be tried. Walls are solid.
///
/// A search over cells of 0.1 m within 4 m (Dijkstra), straightened. Allocates only when it is made.
class Detour {
 public:
  Detour();

  /// Fills `way` with the corners from `from` to `to`, both included. False when walls leave no way.
  [[nodiscard]] bool find(const FreeSpace& space, RoomIndex room, std::span<const ThingPoint> things, Vec2 from,
                          Vec2 to, std::vector<Vec2>& way);
  /// What it costs to go straight along `way`, metres; infinite through a wall. Of the last find()'s surroundings.
  [[nodiscard]] double cost(std::span<const Vec2> way) const noexcept;

  /// Further away nothing is looked at, metres.
  static constexpr double kReach = 4.0;

 private:
  static constexpr double kCell = 0.1;
  static constexpr std::int32_t kSide = 100;
  static constexpr std::int32_t kCells = kSide * kSide;

  void look_at_walls(const FreeSpace& space, RoomIndex room, Vec2 from);
  void look_at_things(std::span<const ThingPoint> things);
  void open_ends(const FreeSpace& space, Vec2 from, Vec2 to);
  [[nodiscard]] bool search(std::int32_t from, std::int32_t to);
  void straighten(Vec2 from, Vec2 to, std::vector<Vec2>& way);
  [[nodiscard]] std::int32_t cell_of(Vec2 p) const noexcept;
  [[nodiscard]] Vec2 middle_of(std::int32_t cell) const noexcept;
  [[nodiscard]] double straight_cost(Vec2 a, Vec2 b) const noexcept;

  RoomIndex room_ = kNoRoom;
  Vec2 origin_{1e9, 1e9};
  std::vector<float> walls_;   ///< By cell: what a metre costs because of walls; infinite where none can stand.
  std::vector<float> effort_;  ///< The same, things taken in.
  std::vector<double> costs_;
  std::vector<std::int32_t> before_;
  struct Open {
    double cost = 0.0;
    std::int32_t cell = 0;
  };
  std::vector<Open> open_;     ///< A heap.
  std::vector<Vec2> path_;
  std::vector<double> along_;  ///< Cost up to each of `path_`.
};

}  // namespace echoway::guidance
