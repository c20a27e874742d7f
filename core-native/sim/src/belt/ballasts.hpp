#pragma once

#include <map>
#include <vector>

#include "echoway/sim/world.hpp"
#include "plan/floor_plan.hpp"

namespace echoway::sim {

/// Fluorescent lights whose electronic ballasts radiate at 47.1 kHz (thesis section 6.2.5, case III). A transducer's
/// metal body picks that up the better the more it faces the lamp; the receiver's gain rises in steps, and at some step
/// the hum crosses the threshold: a steady, false, near reading where the true echo is farther.
class Ballasts {
 public:
  Ballasts(const FloorPlan& plan, double share_of_rooms, std::uint64_t seed)
      : plan_(plan), share_(share_of_rooms), seed_(seed) {}

  void switch_lights(RoomIndex room, bool on) { switched_[room] = on; }

  /// Level of the hum, over threshold at 2 m, in a transducer of that room. `flicker`: a standard normal draw.
  [[nodiscard]] double level(RoomIndex room, Vec2 face, Vec2 axis, double flicker);

 private:
  [[nodiscard]] bool lit(RoomIndex room) const;

  const FloorPlan& plan_;
  double share_;
  std::uint64_t seed_;
  std::map<RoomIndex, bool> switched_;
  std::map<RoomIndex, std::vector<Vec2>> lamps_;
};

}  // namespace echoway::sim
