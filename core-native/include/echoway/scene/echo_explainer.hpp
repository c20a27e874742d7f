#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "echoway/acoustics/element.hpp"
#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"
#include "echoway/geometry/pose2.hpp"
#include "echoway/locate/estimate.hpp"

namespace echoway {

/// A reading, and what in the plan it came from as far as one can say.
struct ExplainedEcho {
  Firing firing{};                       ///< time_s is negative before the sensor's first firing.
  ElementKind kind = ElementKind::none;  ///< `none`: no echo, no position, or nothing mapped agrees with the reading.
  RoomIndex room = kNoRoom;              ///< In whose frame `at` is: the room that the wearer was in.
  Vec2 at{};                             ///< Where the sound turned back.
  double expected_m = Firing::kNoEcho;   ///< What the plan says the range should be; kNoEcho without a `kind`.
};

/// Names what in the plan explains a belt's readings: for a picture of the belt, not for locating.
///
/// Of everything mapped that the wearer's room shows, its open doors included, that lies within a sensor's beam and is
/// not hidden, it takes the nearest whose distance agrees with the reading. A corner that is heard by way of a wall
/// counts as that corner. The beam is widened and the agreement loosened by how well the pose is known.
///
/// REQUIRES: the building outlives the explainer. Never throws after construction, never allocates.
class EchoExplainer {
 public:
  EchoExplainer(const Building& building, const BeltConfig& belt);
  ~EchoExplainer();

  /// `estimate`: where the wearer was at the firing.
  [[nodiscard]] ExplainedEcho explain(const Firing& firing, const Estimate& estimate) const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace echoway
