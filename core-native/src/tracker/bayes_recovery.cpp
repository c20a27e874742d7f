#include <algorithm>

#include "tracker/bayes_core.hpp"
#include "tracker/elementary.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr std::uint64_t kRecoveryWindow = 40;        // Firings that a recovery search looks back on.
constexpr std::uint64_t kBlindRecoveryWindow = 20;   // The same without a gyroscope: a wearer hardly turns meanwhile.
constexpr std::uint64_t kSearchPause = 48;           // Firings between searches.
constexpr double kSurelyAway = 0.5;                  // Who is on the stairs is looked for where they lead.

// In widening circles: a tracker that lost its hold is most often not far off.
constexpr int kCircles = 3;                          // Round about, nearby, everywhere.
constexpr double kRoundAbout = 3.0;                  // Metres.
constexpr double kNearby = 12.0;
constexpr double kHeadingStep = degrees(8.0);

// Log odds that the belief is wrong and what was found instead is right, before its probation: a belief that still fits
// somehow is seldom wrong by a little and hardly ever by much.
constexpr double kLogNear = -7.0;
constexpr double kLogFar = -20.0;
constexpr double kLogNearWhenPoor = -3.0;
constexpr double kLogFarWhenPoor = -8.0;
constexpr double kLogReturn = -7.0;                  // Of the old belief, once it is given up.
// And on the firings that chose it: what does worse than this is not worth a probation.
constexpr double kLogHopeless = -3.0;
constexpr double kLogFoundNear = -3.0;
constexpr double kLogFoundFar = -1.0;

constexpr double kLogHardOfHearing = -3.0;           // That a belt hears nothing from afar.
constexpr int kFarEchoes = 2;                        // One may be a ghost.

}  // namespace

Search::Tools BayesLocator::Core::tools() const {
  const EchoModel& model = hearing_test_ == HearingTest::running ? deafened_ : *model_;
  return {model,     scene_, motion_, belt_, history_, building_, log_scale_, std::max(log_scale_sigma_, kLeastScaleSigma),
          main_.empty() ? 0.0 : summary_.gyro_bias};
}

// Searches when nothing is known yet, and when the echoes fit less well than they used to.
void BayesLocator::Core::pursue_search() {
  if (!search_.running() && !rival_.present()) {
    if (main_.empty()) {
      start_first_search();
    } else {
      start_recovery();
    }
  }
  if (!search_.running() || !search_.work(tools(), random_)) return;
  if (hearing_test_ != HearingTest::done) {
    conclude_first_search();
  } else {
    challenge();
  }
}

void BayesLocator::Core::start_recovery() {
  const std::uint64_t now = history_.end();
  if (!options_.parts.recovery || now < no_search_before_ || now < kRecoveryWindow) return;
  SearchDomain domain;
  domain.heading_sigma = kHeadingStep;
  if (away_ > kSurelyAway) {
    domain.near_room = landing_.room;
    domain.near_position = landing_.at;
    domain.within = kRoundAbout;
    if (gyro_) domain.near_heading = landing_.turn + estimate_.pose.heading;
    search_.start(domain, now - kRecoveryWindow, now);
    return;
  }
  if (away_ > kPerhapsAway || !fit_.doubtful()) return;
  domain.near_room = estimate_.room;
  domain.near_position = estimate_.pose.position;
  const int circle = fit_.poor() ? failed_circles_ : 0;
  if (circle == 0) domain.within = kRoundAbout;
  if (circle == 1) domain.within = kNearby;
  if (circle == 0 && gyro_) domain.near_heading = estimate_.pose.heading;
  search_.start(domain, now - (gyro_ ? kRecoveryWindow : kBlindRecoveryWindow), now);
}

// The first search is made for a belt that hears well. If nothing at all was heard from afar, it is made again for one
// that does not, and whichever explains the firings better is believed.
void BayesLocator::Core::conclude_first_search() {
  if (hearing_test_ == HearingTest::due) {
    search_.take(main_, random_, motion_);
    fit_.reset();
    log_evidence_keen_ = search_.log_evidence();
    hearing_test_ = hears_far() ? HearingTest::done : HearingTest::running;
    if (hearing_test_ == HearingTest::running) search_.start(search_.domain(), search_.window_begin(), history_.end());
    return;
  }
  hearing_test_ = HearingTest::done;
  if (search_.log_evidence() + kLogHardOfHearing < log_evidence_keen_) {
    search_.stop();
    return;
  }
  model_ = &deafened_;
  search_.take(main_, random_, motion_);
  fit_.reset();
}

bool BayesLocator::Core::hears_far() const {
  int far = 0;
  for (std::uint64_t n = history_.begin(); n < history_.end(); ++n) {
    far += history_[n].echo && history_[n].range > kHardOfHearingRange;
  }
  return far >= kFarEchoes;
}

// What the search found may become a rival of the belief.
void BayesLocator::Core::challenge() {
  const std::uint64_t now = history_.end();
  double log_main = 0.0;
  for (std::uint64_t n = search_.window_begin(); n < now; ++n) log_main += history_[n].log_main;
  const double odds = search_.log_evidence() - log_main + (search_.is_local() ? kLogFoundNear : kLogFoundFar);
  no_search_before_ = now + kSearchPause;
  ++searches_;
  if (odds < kLogHopeless) {
    search_.stop();
    note_failed_search();
    return;
  }
  search_.take(rival_.population(), random_, motion_);
  rival_.begin(std::min(odds, handicap()));
  if (!options_.parts.probation) settle_probation(Rival::Verdict::accepted);
}

double BayesLocator::Core::handicap() const {
  const bool near = failed_circles_ == 0 || !fit_.poor();
  if (fit_.poor()) return near ? kLogNearWhenPoor : kLogFarWhenPoor;
  return near ? kLogNear : kLogFar;
}

void BayesLocator::Core::note_failed_search() { failed_circles_ = (failed_circles_ + 1) % kCircles; }

void BayesLocator::Core::settle_probation(Rival::Verdict verdict) {
  if (verdict == Rival::Verdict::undecided) return;
  if (verdict == Rival::Verdict::rejected) {
    rival_.dismiss();
    note_failed_search();
    no_search_before_ = history_.end() + kSearchPause;
    return;
  }
  main_.swap(rival_.population());
  rival_.begin(kLogReturn);   // The old belief may yet turn out to be right.
  failed_circles_ = 0;
  memory_.clear();
  mapped_share_ = kUsuallyMapped;
  fit_.reset();
}

}  // namespace echoway
