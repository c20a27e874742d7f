#pragma once

#include <optional>
#include <span>

#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// Who stands in a doorway. A tracker has them now in the one room and now in the other, though the place is the same.
class Doorstep {
 public:
  /// REQUIRES: both outlive this.
  Doorstep(const Router& router, const GuideConfig& config) : router_(&router), config_(&config) {}

  void clear() noexcept { room_ = kNoRoom; }
  /// Takes an estimate in and gives it back: who has stood for a while stays in the room where they stood, until the
  /// tracker has had them in the other for a while too.
  [[nodiscard]] Estimate settle(const Estimate& estimate) noexcept;

 private:
  [[nodiscard]] std::optional<Estimate> on_this_side(const Estimate& estimate) const noexcept;

  const Router* router_;
  const GuideConfig* config_;
  RoomIndex room_ = kNoRoom;   ///< Where the wearer is taken to be.
  double walked_s_ = -1e300;   ///< When they walked last.
  double other_since_ = -1.0;  ///< The tracker has had them elsewhere since then; negative: it has not.
};

/// How likely the place is, whichever of its rooms who is in a doorway is in; else how likely the room is.
[[nodiscard]] double place_probability(const Router& router, const GuideConfig& config, const Estimate& estimate,
                                       std::span<const Hypothesis> places) noexcept;

}  // namespace echoway::guidance
