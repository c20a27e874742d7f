#include <algorithm>

#include "tracker/bayes_core.hpp"
#include "tracker/elementary.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr std::uint64_t kRecoveryWindow = 40;        // Firings that a recovery search looks back on.
constexpr std::uint64_t kBlindRecoveryWindow = 20;   // The same without a gyroscope: a wearer hardly turns meanwhile.
constexpr std::uint64_t kSearchPause = 48;           // Firings between searches,
constexpr int kMostDoublings = 3;                    // doubled so often at most while they find nothing;
constexpr std::uint64_t kPoorPause = 16;             // against a belief that does not fit, doubled after all circles,
constexpr std::uint64_t kBlindPoorPause = 8;         // never doubled without a gyroscope,
constexpr std::uint64_t kUnconfirmedPause = 24;      // while no place has proved itself yet,
constexpr std::uint64_t kBlindUnconfirmedPause = 32; // and both.
constexpr int kSecondOpinions = 3;                   // Searches in vain until what looks right is left to prove itself.
constexpr double kSomewhere = 0.1;                   // Probability of the likeliest place from which it can be doubted.

// In widening circles: a tracker that lost its hold is most often not far off.
constexpr int kCircles = 3;                          // Round about, nearby, everywhere.
constexpr double kRoundAbout = 3.0;                  // Metres.
constexpr double kNearby = 12.0;
constexpr int kPoorForFar = 16;                      // Firings that a belief fits badly before far places are tried.
constexpr double kHeadingStep = degrees(8.0);
constexpr double kLogLeastGain = 0.0;                // What a coarse look finds about the belief's place, and
constexpr double kLogLeastGainFar = 4.0;             // elsewhere, is dropped unless better than the belief by so much.

// Log odds that the belief is wrong and what was found instead is right, before its probation: a belief that still fits
// somehow is seldom wrong by a little and hardly ever by much.
constexpr double kLogNear = -7.0;
constexpr double kLogNearBlind = -12.0;              // Without a gyroscope it may also be turned round.
constexpr double kLogNearWhenPoor = -3.0;
constexpr double kLogFarWhenPoor = -20.0;            // Halls repeat themselves: a few metres on, much is the same.
constexpr double kLogUnconfirmed = -5.0;             // The same while a place that was found has not proved itself.
constexpr double kLogUnconfirmedWhenPoor = -2.0;
constexpr double kLogReturn = -7.0;                  // Of the old belief, once it is given up.
// And on the firings that chose it: what does worse than this is not worth a probation.
constexpr double kLogHopeless = -3.0;
constexpr double kLogFoundNear = -3.0;
constexpr double kLogFoundFar = -1.0;

// Whether a search that has a belief to beat goes beyond what is round about it.
bool looks_far(const SearchDomain& domain) noexcept { return domain.least_gain && domain.within != kRoundAbout; }

}  // namespace

SearchTools BayesLocator::Core::tools() const {
  const EchoModel& model = hearing_test_ == HearingTest::running ? *other_model_ : *model_;
  return {model, scene_, motion_, belt_, history_, building_,
          log_scale_, std::max(log_scale_sigma_, kLeastScaleSigma),
          main_.empty() ? 0.0 : summary_.gyro_bias, pace_};
}

// Searches when nothing is known yet, and when the echoes fit less well than they used to.
void BayesLocator::Core::pursue_search() {
  if (doubt_ == Doubt::due && !main_.empty()) start_doubting();
  if (!search_.running() && may_search()) {
    if (main_.empty()) {
      start_first_search();
    } else {
      start_recovery();
    }
  }
  if (is_search_needless()) {
    search_.stop();
    last_search_ = history_.end();
  }
  if (!search_.running() || !search_.work(tools(), random_)) return;
  if (hearing_test_ == HearingTest::due) {
    conclude_first_search();
  } else if (hearing_test_ == HearingTest::running) {
    conclude_hearing_test();
  } else if (doubt_ == Doubt::running) {
    conclude_doubt();
  } else {
    challenge();
  }
}

// A belief that fits again is not searched against far and wide; nor is one that has just taken another's place, by
// what that one made of the echoes.
bool BayesLocator::Core::is_search_needless() const {
  return search_.running() && looks_far(search_.domain()) && !fit_.poor();
}

// While the belief explains the echoes one rival at a time is enough; else it is searched against all the while.
bool BayesLocator::Core::may_search() const {
  return rivals_.none() || (unconfirmed_ > 0 ? fit_.doubtful() : fit_.poor());
}

void BayesLocator::Core::start_recovery() {
  const std::uint64_t now = history_.end();
  if (!options_.parts.recovery || now < kRecoveryWindow || now < last_search_ + search_pause()) return;
  const std::uint64_t begin = now - (gyro_ ? kRecoveryWindow : kBlindRecoveryWindow);
  SearchDomain domain;
  domain.levels = &levels_;
  domain.heading_sigma = kHeadingStep;
  if (away_ > kSurelyAway) {
    look_where_stairs_lead(domain, begin);
  } else if (!may_be_elsewhere() || echoes_since(begin) < kFewestEchoes) {
    return;
  } else if (unconfirmed_ > 0) {
    if (start_.room && searches_ == 0) domain.only_room = *start_.room;
    domain.level_heading = compass_at(begin);
    domain.reckoning = &reckoning_;
  } else {
    look_in_a_circle(domain, begin);
    if (looks_far(domain) && poor_for_ < kPoorForFar) return;
  }
  search_.start(domain, begin, now);
}

// While all sorts of places are possible there is nothing that a search could correct.
bool BayesLocator::Core::may_be_elsewhere() const {
  const bool somewhere = summary_.hypotheses[0].probability > kSomewhere;
  const bool unproved = estimate_.state != TrackState::tracking || (gyro_ && fruitless_ < kSecondOpinions);
  return !perhaps_away() && somewhere && (fit_.doubtful() || (unconfirmed_ > 0 && unproved));
}

void BayesLocator::Core::look_where_stairs_lead(SearchDomain& domain, std::uint64_t begin) const {
  domain.near_room = landing_.room;
  domain.near_position = landing_.at;
  domain.within = kRoundAbout;
  if (gyro_) domain.near_heading = landing_.turn + turned_back(estimate_.pose.heading, begin);
}

void BayesLocator::Core::look_in_a_circle(SearchDomain& domain, std::uint64_t begin) const {
  const Pose2 here = likely_pose();
  domain.reckoning = &reckoning_;
  domain.near_room = estimate_.room;
  domain.near_position = here.position;
  const int circle = fit_.poor() ? fruitless_ % kCircles : 0;
  // Without a gyroscope a wrong belief turns to whatever fits, and little is better for a while.
  if (gyro_) domain.least_gain = circle == 0 ? kLogLeastGain : kLogLeastGainFar;
  if (circle == 0) domain.within = kRoundAbout;
  if (circle == 1) domain.within = kNearby;
  if (circle == 0 && gyro_) domain.near_heading = turned_back(here.heading, begin);
}

// Where a belief that fits no longer should be, in the estimate's room's frame: by steps and turns, if counted.
Pose2 BayesLocator::Core::likely_pose() const {
  const Room& room = building_.room(estimate_.room);
  if (!reckoning_.known() || reckoning_.at().level != room.level) return estimate_.pose;
  return room.frame.relative({reckoning_.at().position, reckoning_.at().heading});
}

// A heading of now at an earlier firing, by the gyroscope: a search begins where its window does.
double BayesLocator::Core::turned_back(double heading, std::uint64_t firing) const {
  for (std::uint64_t n = firing + 1; n < history_.end(); ++n) {
    heading -= history_[n].interval.turn_without(summary_.gyro_bias);
  }
  return wrap_angle(heading);
}

// What the compass would have said at a firing, by the turns in between; nothing when no gyroscope told them.
std::optional<double> BayesLocator::Core::compass_at(std::uint64_t firing) const {
  if (!compass_ || compass_said_ < history_.begin()) return {};
  double turned = 0.0;
  for (std::uint64_t n = std::min(firing, compass_said_); n < std::max(firing, compass_said_); ++n) {
    const Interval& interval = history_[n].interval;
    if (n > 0 && !interval.turn_known) return {};
    turned += interval.turn;
  }
  return wrap_angle(*compass_ + (firing > compass_said_ ? turned : -turned));
}

// Added to `log`: what the belief made of the firings since `begin`, each counted as by a search from `first` on.
double BayesLocator::Core::log_belief(std::uint64_t begin, std::uint64_t first, double log) const {
  for (std::uint64_t n = begin; n < history_.end(); ++n) log += share_of(n, first, belt_) * history_[n].log_main;
  return log;
}

// What the search found may become a rival of the belief.
void BayesLocator::Core::challenge() {
  const std::uint64_t first = search_.window_begin();
  const double prior = search_.is_local() ? kLogFoundNear : kLogFoundFar;
  const double odds = search_.log_evidence() - log_belief(first, first) + prior;
  const double log_odds = std::min(odds, handicap());
  last_search_ = history_.end();
  ++searches_;
  ++fruitless_;
  if (odds < kLogHopeless) {
    search_.stop();
    return;
  }
  Rival& rival = rivals_.place_for_another();
  search_.take(rival.population(), tools(), random_);
  rival.begin(log_odds);
  if (!options_.parts.probation) believe(rival);
}

double BayesLocator::Core::handicap() const {
  if (unconfirmed_ > 0) return fit_.poor() ? kLogUnconfirmedWhenPoor : kLogUnconfirmed;
  if (!fit_.poor()) return gyro_ ? kLogNear : kLogNearBlind;
  return fruitless_ % kCircles == 0 ? kLogNearWhenPoor : kLogFarWhenPoor;
}

// Searching again and again what has just been searched in vain costs time and, in the end, finds something by chance.
std::uint64_t BayesLocator::Core::search_pause() const {
  if (fruitless_ == 0 && last_search_ == 0) return 0;
  if (unconfirmed_ > 0) return gyro_ ? kUnconfirmedPause : kBlindUnconfirmedPause;
  if (!fit_.poor()) return kSearchPause << std::min(fruitless_, kMostDoublings);
  return gyro_ ? kPoorPause << std::min(fruitless_ / kCircles, kMostDoublings) : kBlindPoorPause;
}

Rival::Belief BayesLocator::Core::state_of_belief() const {
  if (unconfirmed_ > 0) return Rival::Belief::unproved;
  return fit_.poor() ? Rival::Belief::poor : Rival::Belief::proved;
}

void BayesLocator::Core::judge_rivals(const Record& record, const Evidence& evidence, const Shot& shot) {
  for (Rival& rival : rivals_) {
    if (!rival.present()) continue;
    const double log_plan = update(rival.population(), record, evidence, shot).log_plan;
    const double fit = shows_fit(record) ? fit_.gain(log_plan, record.echo, record.range) : 0.0;
    switch (rival.judge({record.log_main, record.novelty * log_plan, fit}, state_of_belief())) {
      case Rival::Verdict::undecided:
        break;
      case Rival::Verdict::rejected:
        rival.dismiss();
        last_search_ = history_.end();
        break;
      case Rival::Verdict::accepted:
        believe(rival);
        return;
    }
  }
}

// Who was lost and is found anew may be lost again: what replaces a belief that fitted no longer must prove itself as
// what the first search found; until it has, everywhere is searched.
void BayesLocator::Core::believe(Rival& rival) {
  main_.exchange(rival.population(), random_);
  rivals_.dismiss_others(rival);
  rival.begin_return(kLogReturn);   // The old belief may yet turn out to be right.
  if (fit_.poor()) {
    unconfirmed_ = kConfirmed;
  } else {
    fruitless_ = 0;
  }
  understudy_.dismiss();
  forget_surroundings();
  fit_.reset();
}

// What was remembered of them stood about another place.
void BayesLocator::Core::forget_surroundings() {
  memory_.clear();
  mapped_share_ = kUsuallyMapped;
}

void BayesLocator::Core::dismiss_others() noexcept {
  rivals_.dismiss_all();
  understudy_.dismiss();
}

}  // namespace echoway
