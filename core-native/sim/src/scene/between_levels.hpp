#pragma once

#include <map>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/sim/world.hpp"
#include "scene/view.hpp"

namespace echoway::sim {

/// Where a wearer is who is on stairs or in an elevator, of which a plan shows but the two ends. Stairs have a frame of
/// their own: the origin where the first flight begins, x along it. A cabin's origin is its middle, x away from its
/// door.
struct BetweenLevels {
  bool present = false;
  LevelLinkKind kind = LevelLinkKind::stairs;
  int hand = 1;  ///< 1: the second flight lies to the left of the first as one climbs; -1: to the right.
  Pose2 pose{};  ///< Axis and chest, in that frame.
};

/// Dog-leg stairs, two flights a storey, as most stairwells have them (treads and risers of BS 5395-1, DIN 18065).
namespace stairs {
inline constexpr double kGoing = 0.28;   ///< Metres from riser to riser.
inline constexpr double kRise = 0.17;    ///< Height of one.
inline constexpr int kTreads = 9;        ///< A flight.
inline constexpr double kCadence = 1.5;  ///< Treads a second: six seconds a flight.
inline constexpr double kRun = kTreads * kGoing;

/// The way over one storey, from landing to landing.
[[nodiscard]] std::vector<Vec2> path(bool up, int hand);
/// From one storey's last flight round to the next one's first.
[[nodiscard]] std::vector<Vec2> landing(bool up, int hand);
/// Height of the feet above the lower landing, metres.
[[nodiscard]] double height(Vec2 at, int hand) noexcept;
/// True on a flight, where every tread is a step.
[[nodiscard]] bool on_flight(Vec2 at) noexcept;
}  // namespace stairs

/// What the belt hears there: the walls of the stairwell, balusters, and the risers that stand as high as the belt,
/// which come nearer and go as the wearer climbs; or the walls of a cabin.
class BetweenLevelsViews {
 public:
  explicit BetweenLevelsViews(const World& world) : world_(world) {}

  [[nodiscard]] const View& view_from(const BetweenLevels& place);

 private:
  const World& world_;
  std::map<int, View> views_;
};

}  // namespace echoway::sim
