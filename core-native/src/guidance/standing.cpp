#include "guidance/standing.hpp"

#include <algorithm>

namespace echoway::guidance {

Estimate Standing::settle(const Estimate& e, bool walking) noexcept {
  constexpr double kSlack = 0.15;  // metres: who is farther off than this and the error has moved all the same
  constexpr double kSigmas = 2.5;
  constexpr double kSurest = 0.05; // metres
  constexpr double kMost = 200.0;  // positions as sure as this one; then old ones begin to fade
  if (walking) {
    clear();
    return e;
  }
  const bool moved = e.room != room_ || distance(mean_, e.pose.position) > kSlack + kSigmas * e.sigma_m;
  if (moved) clear();
  room_ = e.room;
  const double sigma = std::max(e.sigma_m, kSurest);
  const double weight = 1.0 / (sigma * sigma);
  weight_ = std::min(weight_ + weight, kMost * weight);
  mean_ = mean_ + std::min(weight / weight_, 1.0) * (e.pose.position - mean_);
  Estimate settled = e;
  settled.pose.position = mean_;
  return settled;
}

}  // namespace echoway::guidance
