#include "tracker/rival.hpp"

namespace echoway::tracker {
namespace {

constexpr double kLogAccepted = 6.0;
constexpr double kLogRejected = -30.0;
constexpr std::uint64_t kProbation = 128;   // Firings: eight seconds.

}  // namespace

void Rival::begin(double log_odds) noexcept {
  log_odds_ = log_odds;
  age_ = 0;
}

Rival::Verdict Rival::judge(double log_belief, double log_rival) noexcept {
  log_odds_ += log_rival - log_belief;
  ++age_;
  if (log_odds_ < kLogRejected || age_ > kProbation) return Verdict::rejected;
  return log_odds_ < kLogAccepted ? Verdict::undecided : Verdict::accepted;
}

}  // namespace echoway::tracker
