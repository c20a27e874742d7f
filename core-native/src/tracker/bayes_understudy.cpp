#include <utility>

#include "tracker/bayes_core.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr int kGap = 32;   // Firings without a gyroscope's readings, two seconds, that are no more than a gap in them.

}  // namespace

// With a gyroscope hardly any turn is missed, and a second belief would double what a firing costs. Nor does one help
// while many places are in mind already.
void BayesLocator::Core::follow_understudy(Record& record, const HintIntegrator::GaitEvidence& gait, const Shot& shot) {
  if (blind_for_ <= kGap || !options_.parts.understudy) return understudy_.dismiss();
  if (!understudy_.present()) {
    if (estimate_.state == TrackState::tracking && !fit_.doubtful()) begin_understudy();
    return;
  }
  const Verdict verdict = update(understudy_.population(), record, gait, shot);
  record.log_second = record.novelty * verdict.log_plan;
  if (record.trust > 0.5) understudy_.fit().observe(verdict.log_plan, record.echo, record.range);
  switch (understudy_.judge(record.log_main, record.log_second)) {
    case Understudy::Verdict::alike:
      break;
    case Understudy::Verdict::ahead:
      believe_understudy();
      break;
    case Understudy::Verdict::behind:
      begin_understudy();
      break;
  }
}

void BayesLocator::Core::begin_understudy() { understudy_.learn(main_, fit_, history_.end(), random_); }

// What it has made of the echoes so far is then the belief's past, for a search to beat.
void BayesLocator::Core::believe_understudy() {
  main_.exchange(understudy_.population(), random_);
  std::swap(fit_, understudy_.fit());
  history_.exchange(understudy_.since());
  forget_surroundings();
}

}  // namespace echoway
