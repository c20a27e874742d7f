#include "tracker/rival.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {

constexpr double kLogAccepted = 6.0;
constexpr double kLogUnfit = 16.0;          // More is asked of who explains the echoes hardly better than no place:
constexpr double kFitting = 0.3;            // by less than this a firing. Among people and things that no plan knows,
                                            // some wrong place is always a little better than the right one.
constexpr double kLogRejected = -30.0;
constexpr double kLogSlump = 8.0;           // Against a poor belief whoever is right does not fall back by so much,
constexpr double kLogGain = 0.1;            // and gains so much a firing: others must not keep the next search waiting.
constexpr std::uint64_t kProbation = 128;   // Firings: eight seconds.

}  // namespace

void Rival::begin(double log_odds) noexcept {
  log_begin_ = log_odds_ = log_odds;
  fit_ = 0.0;
  found_ = true;
  age_ = 0;
}

void Rival::begin_return(double log_odds) noexcept {
  begin(log_odds);
  found_ = false;
}

double Rival::least(Belief belief) const noexcept {
  return belief == Belief::poor ? std::max(kLogRejected, log_begin_ - kLogSlump + kLogGain * static_cast<double>(age_))
                                : kLogRejected;
}

bool Rival::fits() const noexcept { return fit_ >= kFitting * static_cast<double>(age_); }

double Rival::needed(Belief belief) const noexcept {
  const bool must_fit = found_ && belief != Belief::unproved;
  return must_fit && !fits() ? kLogAccepted + kLogUnfit : kLogAccepted;
}

// Who gains all the while on a belief that does not fit is about to win.
bool Rival::overdue(Belief belief) const noexcept {
  const bool gaining = gain() > kLogGain * static_cast<double>(age_);
  return age_ > kProbation && !(belief == Belief::poor && gaining);
}

Rival::Verdict Rival::judge(const Heard& heard, Belief belief) noexcept {
  log_odds_ += heard.log_rival - heard.log_belief;
  fit_ += heard.fit;
  ++age_;
  if (log_odds_ < least(belief) || overdue(belief)) return Verdict::rejected;
  return log_odds_ < needed(belief) ? Verdict::undecided : Verdict::accepted;
}

}  // namespace echoway::tracker
