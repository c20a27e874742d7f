#include "live_report.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <span>

#include "echoway/io/logs.hpp"

namespace echoway::tools {
namespace {

constexpr double kPrintInterval = 1.0;

}  // namespace

void LiveReport::update() {
  print_cues();
  print_position();
  std::fflush(stdout);
}

void LiveReport::print_belt() const {
  const BeltHealth& belt = session_.belt_health();
  fmt::print("{} sentences; dropped {} with a bad checksum, {} malformed; {} firings lost\n", belt.good_sentences,
             belt.bad_checksums, belt.malformed, belt.lost_firings);
  std::fflush(stdout);
}

void LiveReport::print_cues() {
  const std::size_t fresh = voice_.collect();
  for (const SpokenCue& cue : std::span(voice_.cues()).last(fresh)) fmt::print("{}\n", cue.text);
}

void LiveReport::print_position() {
  const Estimate& estimate = session_.estimate();
  if (estimate.room == kNoRoom) return;
  const bool changed = estimate.room != room_ || estimate.state != state_;
  if (!changed && estimate.time_s - printed_at_ < kPrintInterval) return;
  const Room& room = session_.building().room(estimate.room);
  fmt::print("{:8.2f} s  room {} {}  x {:.2f} m  y {:.2f} m  heading {:.0f} deg  sigma {:.2f} m  {:.0f} %  {}\n",
             estimate.time_s, room.id, room.name, estimate.pose.position.x, estimate.pose.position.y,
             to_degrees(estimate.pose.heading), estimate.sigma_m, 100.0 * estimate.room_probability,
             to_string(estimate.state));
  room_ = estimate.room;
  state_ = estimate.state;
  printed_at_ = estimate.time_s;
}

}  // namespace echoway::tools
