#include "tracker/bayes_core.hpp"

namespace echoway {

using namespace tracker;

namespace {

// Firings without a gyroscope's readings, two seconds, that are no more than a gap in them; and for as long after a
// start all particles serve one belief.
constexpr int kGap = 32;

}  // namespace

// With a gyroscope hardly any turn is missed, and a second belief would double what a firing costs. Nor does one help
// while many places are in mind already; and while a place is doubted, no other may take its name.
void BayesLocator::Core::follow_understudy(Record& record, const Evidence& evidence, const Shot& shot) {
  const bool needless = blind_for_ <= kGap || doubt_ == Doubt::running;
  if (needless || !options_.parts.understudy) return understudy_.dismiss();
  if (!understudy_.present()) {
    if (estimate_.state == TrackState::tracking && !fit_.doubtful()) begin_understudy();
    return;
  }
  const Verdict verdict = update(understudy_.population(), record, evidence, shot);
  record.log_second = record.novelty * verdict.log_plan;
  show(understudy_.fit(), verdict, record);
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

void BayesLocator::Core::believe_understudy() {
  understudy_.change_places(main_, fit_, history_, random_);
  forget_surroundings();
}

}  // namespace echoway
