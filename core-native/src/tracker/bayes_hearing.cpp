// Whether the belt hears what is far. Sensors that are weak, or worn under a coat, hear what is near and nothing
// else: their silence says little.

#include "tracker/bayes_core.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr double kLogHardOfHearing = -3.0;   // That a belt hears nothing from afar.
constexpr int kFarEchoes = 2;                // One may be a ghost.
constexpr double kNearRange = 1.5;           // Metres: a belt that hears from beyond does not hear only what is near.
constexpr double kSmallArea = 40.0;          // Square metres that a search looks through within a second.

}  // namespace

int BayesLocator::Core::echoes_beyond(double range) const {
  int far = 0;
  for (std::uint64_t n = history_.begin(); n < history_.end(); ++n) {
    far += history_[n].echo && history_[n].range > range;
  }
  return far;
}

bool BayesLocator::Core::hears_far() const { return echoes_beyond(kHardOfHearingRange) >= kFarEchoes; }

// Whether the first search is made for a belt of weak sensors first. In a large place that would keep those with a
// good belt, who are more, waiting.
bool BayesLocator::Core::seems_hard_of_hearing(RoomIndex only_room) const {
  const double area = only_room == kNoRoom ? search_.area() : scene_.room(only_room).box_area();
  return area < kSmallArea && echoes_beyond(kNearRange) == 0;
}

// A belt that was taken for one of weak sensors shows what it is by hearing from afar; a first search made for such a
// belt begins anew. Any other search under way weighs all places alike.
void BayesLocator::Core::choose_model(const Record& record) {
  const bool from_afar = record.echo && record.range > kHardOfHearingRange;
  const bool stays = model_ == &deafened_ ? !(from_afar && hears_far()) : search_.running();
  if (stays) return;
  const bool known = !main_.empty() && unconfirmed_ == 0;
  model_ = known ? &wary_ : &keen_;
  if (main_.empty() && search_.running()) start_first_search();
}

// If nothing at all was heard from afar, the first search is made again for a belt that hears better, or worse, than
// was taken for granted. What the first one found is followed meanwhile.
void BayesLocator::Core::conclude_first_search() {
  const bool deafened = model_ == &deafened_;
  search_.take(main_, tools(), random_);
  fit_.reset();
  unconfirmed_ = kConfirmed;
  hearing_test_ = hears_far() ? HearingTest::done : HearingTest::running;
  if (hearing_test_ == HearingTest::done) return;
  other_model_ = deafened ? &keen_ : &deafened_;
  log_first_ = search_.log_evidence() + (deafened ? kLogHardOfHearing : -kLogHardOfHearing);
  first_until_ = history_.end();
  search_.start(search_.domain(), search_.window_begin(), first_until_);
}

// Whichever of the two explains the firings better is believed: those too that came while the second was looked for.
void BayesLocator::Core::conclude_hearing_test() {
  hearing_test_ = HearingTest::done;
  if (search_.log_evidence() < log_belief(first_until_, search_.window_begin(), log_first_)) {
    search_.stop();
    return;
  }
  model_ = other_model_;
  understudy_.dismiss();
  search_.take(main_, tools(), random_);
  fit_.reset();
}

}  // namespace echoway
