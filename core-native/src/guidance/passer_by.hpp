#pragma once

#include <vector>

#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/announcer.hpp"

namespace echoway::guidance {

/// What a walker without a destination comes by: doors, exits, stairs, elevators and places, once each time.
class PasserBy {
 public:
  /// REQUIRES: `router` outlives this.
  explicit PasserBy(const Router& router) : router_(&router), told_places_(router.building().places.size(), false) {}

  void tell(const Estimate& estimate, Announcer& voice);
  void clear() noexcept;

 private:
  void tell_passage(const Estimate& estimate, Announcer& voice);
  void tell_place(const Estimate& estimate, std::size_t place, Announcer& voice);

  const Router* router_;
  CueLandmark told_passage_{};     ///< The last one.
  std::vector<bool> told_places_;  ///< By place: told, and not left since.
};

}  // namespace echoway::guidance
