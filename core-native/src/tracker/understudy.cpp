#include "tracker/understudy.hpp"

#include <algorithm>
#include <utility>

namespace echoway::tracker {
namespace {

constexpr double kLogAhead = 8.0;
constexpr double kLogBehind = 16.0;    // Another belief that is given up cannot help any more.
constexpr double kLogMost = 3.0;       // Of one firing: no single echo decides.

}  // namespace

void Understudy::learn(const Population& belief, const FitMonitor& fit, std::uint64_t next, Random& random) noexcept {
  population_.copy(belief, random);
  fit_ = fit;
  since_ = next;
  gained_ = lost_ = 0.0;
}

void Understudy::change_places(Population& belief, FitMonitor& fit, History& history, Random& random) noexcept {
  belief.exchange(population_, random);
  std::swap(fit, fit_);
  history.exchange(since_);
}

Understudy::Verdict Understudy::judge(double log_belief, double log_own) noexcept {
  const double gain = std::clamp(log_own - log_belief, -kLogMost, kLogMost);
  gained_ = std::max(gained_ + gain, 0.0);
  lost_ = std::max(lost_ - gain, 0.0);
  const bool ahead = gained_ > kLogAhead;
  if (!ahead && !(lost_ > kLogBehind)) return Verdict::alike;
  gained_ = lost_ = 0.0;
  return ahead ? Verdict::ahead : Verdict::behind;
}

}  // namespace echoway::tracker
