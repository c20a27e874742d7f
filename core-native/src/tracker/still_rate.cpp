#include "tracker/still_rate.hpp"

#include <cmath>

namespace echoway::tracker {
namespace {

constexpr double kStill = degrees(3.5);   // rad/s: nobody turns so slowly on purpose.
constexpr double kLongEnough = 1.0;       // Seconds.
constexpr double kGap = 0.3;              // Seconds without a reading.

}  // namespace

void StillRate::note(double time_s, double rate, bool stepping) noexcept {
  const bool still = !stepping && std::abs(rate) < kStill;
  if (!still || time_s - last_ > kGap || time_s < last_) count_ = 0;
  last_ = time_s;
  if (!still) return;
  if (count_ == 0) {
    begin_ = time_s;
    sum_ = 0.0;
  }
  sum_ += rate;
  ++count_;
  if (time_s - begin_ < kLongEnough) return;
  mean_ = sum_ / count_;
  count_ = 0;
}

std::optional<double> StillRate::take() noexcept {
  const auto mean = mean_;
  mean_.reset();
  return mean;
}

}  // namespace echoway::tracker
