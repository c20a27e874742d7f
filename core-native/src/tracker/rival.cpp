#include "tracker/rival.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {

constexpr double kLogAccepted = 6.0;
constexpr double kLogRejected = -30.0;
constexpr double kLogSlump = 8.0;           // Against a poor belief whoever is right does not fall back by so much,
constexpr double kLogGain = 0.1;            // and gains so much a firing: others must not keep the next search waiting.
constexpr std::uint64_t kProbation = 128;   // Firings: eight seconds.

}  // namespace

void Rival::begin(double log_odds) noexcept {
  log_begin_ = log_odds_ = log_odds;
  age_ = 0;
}

double Rival::least(bool belief_poor) const noexcept {
  return belief_poor ? std::max(kLogRejected, log_begin_ - kLogSlump + kLogGain * static_cast<double>(age_))
                     : kLogRejected;
}

// Who gains all the while on a belief that does not fit is about to win.
bool Rival::overdue(bool belief_poor) const noexcept {
  const bool gaining = gain() > kLogGain * static_cast<double>(age_);
  return age_ > kProbation && !(belief_poor && gaining);
}

Rival::Verdict Rival::judge(double log_belief, double log_rival, bool belief_poor) noexcept {
  log_odds_ += log_rival - log_belief;
  ++age_;
  if (log_odds_ < least(belief_poor) || overdue(belief_poor)) return Verdict::rejected;
  return log_odds_ < kLogAccepted ? Verdict::undecided : Verdict::accepted;
}

}  // namespace echoway::tracker
