#include "belt_time.hpp"

#include <algorithm>

namespace echoway::tools {
namespace {

// A belt that fires this many times faster than expected is still taken for one.
constexpr double kFastest = 2.5;
// So many sentences may come at once all the same: a second of them, that the host was too busy to read.
constexpr double kBurst = 16.0;

}  // namespace

void BeltTime::on_read(std::size_t sentences, double host_s) {
  const double drained = kFastest / slot_ * (host_s - read_at_);
  pressure_ = std::min(std::max(0.0, pressure_ - drained) + static_cast<double>(sentences), 2.0 * kBurst);
  pressed_ = pressure_ > kBurst;
  read_at_ = host_s;
}

void BeltTime::on_firings(int firings, std::uint64_t lost, double host_s) {
  if (firings == 0) return;
  last_ = next() + (pressed_ ? slot_ * (firings - 1 + static_cast<double>(lost)) : 0.0);
  told_ = std::max(told_, last_);
  if (pressed_) ahead_ = last_ - host_s;
}

}  // namespace echoway::tools
