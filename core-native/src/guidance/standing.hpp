#pragma once

#include "echoway/locate/estimate.hpp"

namespace echoway::guidance {

/// Where somebody who stands is: the mean of all positions since they stopped, the surer ones counting more. One that
/// errs for a moment says nothing then, and waiting for one that suits does not help.
class Standing {
 public:
  /// Takes an estimate in and gives it back, at the mean while the wearer stands.
  [[nodiscard]] Estimate settle(const Estimate& estimate, bool walking) noexcept;
  void clear() noexcept { weight_ = 0.0; }

 private:
  RoomIndex room_ = kNoRoom;
  Vec2 mean_{};
  double weight_ = 0.0;
};

}  // namespace echoway::guidance
