#pragma once

#include <span>
#include <vector>

#include "echoway/routing/route.hpp"

namespace echoway::guidance {

/// Where the wearer has been, for the way back.
class Breadcrumbs {
 public:
  Breadcrumbs();
  /// The wearer is known to be `here`.
  void drop(const Spot& here);
  void clear() noexcept { crumbs_.clear(); }
  /// Oldest first.
  [[nodiscard]] const std::vector<Spot>& all() const noexcept { return crumbs_; }

 private:
  std::vector<Spot> crumbs_;
};

}  // namespace echoway::guidance
