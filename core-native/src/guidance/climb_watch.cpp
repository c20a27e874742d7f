#include "guidance/climb_watch.hpp"

#include <algorithm>

namespace echoway::guidance {

void ClimbWatch::update(const Estimate& e) noexcept {
  constexpr double kAt = 1.5;  // metres
  clear();
  for (const LevelLink& link : router_->building().links) {
    const bool at_a = link.room_a == e.room && distance(link.at_a, e.pose.position) < kAt;
    const bool at_b = link.room_b == e.room && distance(link.at_b, e.pose.position) < kAt;
    if (!at_a && !at_b) continue;
    until_ = std::max(until_, e.time_s + config_->unasked_share * config_->patience_s(link.kind));
  }
}

}  // namespace echoway::guidance
