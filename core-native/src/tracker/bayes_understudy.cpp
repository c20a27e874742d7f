#include "tracker/bayes_core.hpp"

namespace echoway {

using namespace tracker;

// With a gyroscope hardly any turn is missed, and a second belief would double what a firing costs. Nor does one help
// while many places are in mind already.
void BayesLocator::Core::follow_understudy(const Record& record, const HintIntegrator::GaitEvidence& gait,
                                           const Shot& shot) {
  if (gyro_ || !options_.parts.understudy) return understudy_.dismiss();
  if (!understudy_.present()) {
    if (estimate_.state == TrackState::tracking && !fit_.doubtful()) understudy_.learn(main_, random_);
    return;
  }
  const double log_own = record.novelty * update(understudy_.population(), record, gait, shot).log_plan;
  switch (understudy_.judge(record.log_main, log_own)) {
    case Understudy::Verdict::alike:
      break;
    case Understudy::Verdict::ahead:
      main_.swap(understudy_.population());
      forget_surroundings();
      break;
    case Understudy::Verdict::behind:
      understudy_.learn(main_, random_);
      break;
  }
}

}  // namespace echoway
