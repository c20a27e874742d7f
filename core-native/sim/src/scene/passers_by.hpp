#pragma once

#include <map>
#include <vector>

#include "acoustics/echo_paths.hpp"
#include "plan/floor_plan.hpp"
#include "scene/view.hpp"

namespace echoway::sim {

/// People who stroll about in their rooms, from place to place with pauses.
class PassersBy {
 public:
  PassersBy(const FloorPlan& plan, double per_100m2, std::uint64_t seed)
      : plan_(plan), per_100m2_(per_100m2), seed_(seed) {}

  /// Those in the view's rooms at `time_s`, in the view's frame; they make way for a wearer at `wearer`. Times must not
  /// go back.
  void add(const View& view, double time_s, Vec2 wearer, std::vector<Obstacle>& obstacles);

 private:
  struct Person {
    Random random{0};
    Vec2 from{};
    std::vector<Vec2> way;   // Still to go, nearest last.
    double left_at_s = 0.0;  // When `from` was, or is to be, left.
    double speed = 1.0;

    [[nodiscard]] Vec2 at(double time_s, const RoomGrid& grid);
  };

  std::vector<Person>& of(RoomIndex room, double time_s);

  const FloorPlan& plan_;
  double per_100m2_;
  std::uint64_t seed_;
  std::map<RoomIndex, std::vector<Person>> people_;
};

}  // namespace echoway::sim
