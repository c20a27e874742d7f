#include "live_report.hpp"

#include <fmt/core.h>

#include <cstdio>

#include "echoway/io/logs.hpp"

namespace echoway::tools {
namespace {

constexpr double kPrintInterval = 1.0;

}  // namespace

void LiveReport::update(const Session& session) {
  print_link(session.belt_health().link);
  print_position(session);
  std::fflush(stdout);
}

void LiveReport::print_link(BeltLink link) {
  if (link == link_) return;
  if (link == BeltLink::connected) fmt::print("Belt connected.\n");
  if (link == BeltLink::lost) fmt::print("Belt disconnected.\n");
  link_ = link;
}

void LiveReport::print_position(const Session& session) {
  const Estimate& estimate = session.estimate();
  if (estimate.room == kNoRoom) return;
  const bool changed = estimate.room != room_ || estimate.state != state_;
  if (!changed && estimate.time_s - printed_at_ < kPrintInterval) return;
  const Room& room = session.building().room(estimate.room);
  fmt::print("{:8.2f} s  room {} {}  x {:.2f} m  y {:.2f} m  heading {:.0f} deg  sigma {:.2f} m  {:.0f} %  {}\n",
             estimate.time_s, room.id, room.name, estimate.pose.position.x, estimate.pose.position.y,
             to_degrees(estimate.pose.heading), estimate.sigma_m, 100.0 * estimate.room_probability,
             to_string(estimate.state));
  room_ = estimate.room;
  state_ = estimate.state;
  printed_at_ = estimate.time_s;
}

}  // namespace echoway::tools
