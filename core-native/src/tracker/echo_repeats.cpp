#include "tracker/echo_repeats.hpp"

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kOldest = 2.5;          // Seconds after which an echo is forgotten.
constexpr double kSigma = 0.08;          // Metres,
constexpr double kSigmaPerSecond = 0.06; // and for every second since.

}  // namespace

void EchoRepeats::note(int sensor, double range, double time_s) noexcept {
  last_[slot_of(sensor)] = {sensor, time_s, range};
}

std::span<const Repeat> EchoRepeats::match(int sensor, double range, double time_s) noexcept {
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < last_.size(); ++slot) {
    const Last& last = last_[slot];
    const double age = time_s - last.time_s;
    if (!(age >= 0.0 && age < kOldest)) continue;
    const double sigma = kSigma + kSigmaPerSecond * age;
    const double alike = last.sensor == sensor ? gaussian(range - last.range, sigma) : 0.0;
    found_[count++] = {slot, sigma, alike};
  }
  return {found_.data(), count};
}

}  // namespace echoway::tracker
