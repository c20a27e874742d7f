#include "echoway/belt/firing_clock.hpp"

#include <algorithm>

namespace echoway {
namespace {

// More firings than this in one gap are taken for a restarted sequence rather than a loss: four minutes at 16 a second.
constexpr std::uint16_t kLargestGap = 4096;
// A gap between two arrivals that exceeds its share of the beat by this much is a pause of the belt: the line is drawn
// anew. (A belt that is merely slower than configured falls behind little by little, which the blocks correct.)
constexpr double kPause = 0.5;
// Firings in a block: two seconds, long enough to hold one that came without delay.
constexpr std::int64_t kBlock = 32;
// How far one block's slope moves the beat.
constexpr double kBeatGain = 0.5;
// The beat stays within this factor of the configured slot.
constexpr double kBeatLimit = 4.0;
// Arrivals this far behind mean that the host's clock was set back.
constexpr double kSetBack = 10.0;

}  // namespace

FiringClock::FiringClock(double slot_s) : nominal_slot_(slot_s), slot_(slot_s) {}

void FiringClock::reset() {
  started_ = false;
  slot_ = nominal_slot_;
}

void FiringClock::anchor(double arrival_s) {
  line_ = arrival_s;
  block_ = {};
  previous_block_ = {};
  block_start_ = index_;
}

void FiringClock::follow(double arrival_s) {
  const double lateness = arrival_s - line_;
  if (!block_.known || lateness < block_.lateness) block_ = {lateness, arrival_s, index_, true};
  if (lateness < 0.0) {
    line_ = arrival_s;
    block_.lateness = 0.0;
  }
  if (index_ - block_start_ >= kBlock) end_block();
}

void FiringClock::end_block() {
  // A whole block behind the line: the line runs early.
  line_ += block_.lateness;
  if (previous_block_.known && block_.index > previous_block_.index) {
    const double slope =
        (block_.arrival - previous_block_.arrival) / static_cast<double>(block_.index - previous_block_.index);
    // A slope beyond the limits is no beat: arrivals that were held up and came all at once.
    const bool beat = slope > nominal_slot_ / kBeatLimit && slope < nominal_slot_ * kBeatLimit;
    if (beat) slot_ += kBeatGain * (slope - slot_);
  }
  previous_block_ = block_;
  block_ = {};
  block_start_ = index_;
}

FiringClock::Stamp FiringClock::stamp(std::uint16_t seq, double arrival_s) {
  Stamp result;
  const auto step = static_cast<std::uint16_t>(seq - last_seq_);
  if (!started_) {
    anchor(arrival_s);
  } else if (step == 0 || step > kLargestGap) {
    result.restarted = true;
    anchor(arrival_s);
  } else {
    result.lost = step - 1U;
    index_ += step;
    line_ += step * slot_;
    if (arrival_s - last_arrival_ > step * slot_ + kPause) {
      anchor(arrival_s);
    } else {
      follow(arrival_s);
    }
  }
  started_ = true;
  last_seq_ = seq;
  last_arrival_ = arrival_s;
  last_time_ = line_ < last_time_ - kSetBack ? line_ : std::max(last_time_, line_);
  result.time_s = last_time_;
  return result;
}

}  // namespace echoway
