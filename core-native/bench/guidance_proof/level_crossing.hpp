#pragma once

#include <vector>

#include "scene/between_levels.hpp"

namespace echoway::proof {

/// A steady walk over a staircase, or a ride in a cabin, from its beginning (share 0) to its end (share 1).
class LevelCrossing {
 public:
  LevelCrossing() = default;
  LevelCrossing(LevelLinkKind kind, int storeys, bool up, int hand);

  struct Moment {
    sim::BetweenLevels place{};
    double turned = 0.0;  ///< Since the beginning, radians.
    double steps = 0.0;   ///< The same, feet put down.
  };
  [[nodiscard]] Moment at(double share) const;

 private:
  void stand(double seconds, double turn);
  void walk(Vec2 to);

  struct Key {
    double time_s = 0.0;
    Vec2 at{};
    double heading = 0.0;  ///< Unwrapped.
    double steps = 0.0;
  };
  LevelLinkKind kind_ = LevelLinkKind::stairs;
  int hand_ = 1;
  std::vector<Key> keys_;
};

}  // namespace echoway::proof
