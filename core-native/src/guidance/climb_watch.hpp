#pragma once

#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// Whoever is at stairs or an elevator may take them unasked: then echoes need not fit for a while.
class ClimbWatch {
 public:
  /// REQUIRES: both outlive this.
  ClimbWatch(const Router& router, const GuideConfig& config) : router_(&router), config_(&config) {}

  /// The wearer is known to be there.
  void update(const Estimate& estimate) noexcept;
  void clear() noexcept { until_ = -1e300; }
  /// They may be on their way up to this time.
  [[nodiscard]] double until() const noexcept { return until_; }

 private:
  const Router* router_;
  const GuideConfig* config_;
  double until_ = -1e300;
};

}  // namespace echoway::guidance
