// Whether the belt hears what is far. Sensors that are weak, or worn under a coat, hear what is near and nothing else: their
// silence says little.

#include "tracker/bayes_core.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr double kLogHardOfHearing = -3.0;   // That a belt hears nothing from afar.
constexpr int kFarEchoes = 2;                // One may be a ghost.
constexpr double kNearRange = 1.5;           // Metres: a belt that hears something from beyond does not hear only what is near.
constexpr double kSmall = 40.0;              // Square metres that a search looks through within a second.

}  // namespace

int BayesLocator::Core::echoes_beyond(double range) const {
  int far = 0;
  for (std::uint64_t n = history_.begin(); n < history_.end(); ++n) far += history_[n].echo && history_[n].range > range;
  return far;
}

bool BayesLocator::Core::hears_far() const { return echoes_beyond(kHardOfHearingRange) >= kFarEchoes; }

// Whether the first search begins with a belt of weak sensors. Where there is much to look through that would keep the wearer
// of a good one, of whom there are more, waiting for their place.
bool BayesLocator::Core::seems_hard_of_hearing(RoomIndex only_room) const {
  double area = 0.0;
  for (std::size_t i = 0; i < scene_.room_count(); ++i) {
    const auto r = static_cast<RoomIndex>(i);
    const Vec2 size = scene_.room(r).high - scene_.room(r).low;
    if (only_room == kNoRoom || only_room == r) area += size.x * size.y;
  }
  return area < kSmall && echoes_beyond(kNearRange) == 0;
}

// A belt that was taken for one of weak sensors shows what it is by hearing from afar; a first search made for such a belt
// begins anew. Any other search under way weighs all places alike.
void BayesLocator::Core::choose_model(const Record& record) {
  const bool from_afar = record.echo && record.range > kHardOfHearingRange;
  const bool stays = model_ == &deafened_ ? !(from_afar && hears_far()) : search_.running();
  if (stays) return;
  const bool known = !main_.empty() && unconfirmed_ == 0;
  model_ = known ? &wary_ : &keen_;
  if (main_.empty() && search_.running()) start_first_search();
}

// If nothing at all was heard from afar, the first search is made again for a belt that hears better, or worse, than was
// taken for granted; whichever explains the firings better is believed. The first has meanwhile been followed, so that both
// answer for the same firings.
void BayesLocator::Core::conclude_first_search() {
  const std::uint64_t now = history_.end();
  const std::uint64_t first = search_.window_begin();
  if (hearing_test_ == HearingTest::due) {
    const bool deafened = model_ == &deafened_;
    search_.take(main_, random_);
    fit_.reset();
    unconfirmed_ = kConfirmed;
    hearing_test_ = hears_far() ? HearingTest::done : HearingTest::running;
    if (hearing_test_ == HearingTest::done) return;
    other_model_ = deafened ? &keen_ : &deafened_;
    log_first_ = search_.log_evidence() + (deafened ? kLogHardOfHearing : -kLogHardOfHearing);
    first_until_ = now;
    search_.start(search_.domain(), first, now);
    return;
  }
  hearing_test_ = HearingTest::done;
  for (std::uint64_t n = first_until_; n < now; ++n) log_first_ += share_of(n, first, belt_) * history_[n].log_main;
  if (search_.log_evidence() < log_first_) {
    search_.stop();
    return;
  }
  model_ = other_model_;
  search_.take(main_, random_);
  fit_.reset();
}

}  // namespace echoway
