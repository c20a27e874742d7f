#include <algorithm>
#include <cmath>

#include "tracker/bayes_core.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr std::uint64_t kDoubtWindow = 80;           // Firings that a search out of doubt looks back on.
constexpr std::size_t kKept = 1200;                  // Particles of the belief that is doubted.
constexpr double kLeastHere = 0.2;                   // What a search, which is coarse, may miss of it.
constexpr double kDoubtedOdds = 0.5;                 // Of the place that is doubted,
constexpr double kDoubted = 1.0;                     // which reaches so many metres
constexpr double kDoubtedTurn = degrees(60.0);       // and so far round.
constexpr double kLinkOdds = 0.05;                   // The same of stairs to be taken: who finds none is not there.

}  // namespace

// Who leads the wearer has reason to think them elsewhere, whatever the echoes say: everywhere is looked at again.
void BayesLocator::Core::start_doubting() {
  const std::uint64_t now = history_.end();
  doubted_link_ = link_to_take();
  if (doubted_link_) {
    const bool on_it = away_ > kSurelyAway;
    if (on_it) land_all();
    links_.expect({});   // Whether they have taken it or not, they do so no longer.
    if (on_it) return;
  }
  const bool away = perhaps_away() && !doubted_link_;
  if (hearing_test_ != HearingTest::done || away || now < kDoubtWindow) return;
  const std::uint64_t begin = now - kDoubtWindow;
  if (echoes_since(begin) < kFewestEchoes) return;
  rivals_.dismiss_all();
  if (model_ == &wary_) model_ = &keen_;
  search_.start({.thorough = true}, begin, now);
  doubt_ = Doubt::running;
}

// Nobody asks in mid-flight: who is away stands at the other end, though the echoes do not tell.
void BayesLocator::Core::land_all() {
  for (Particle& p : main_.particles()) {
    if (p.gait == Gait::away) links_.land(p, last_time_, gyro_, random_);
  }
  dismiss_others();
  search_.stop();
  doubt_ = Doubt::none;
  unconfirmed_ = kConfirmed;
  fruitless_ = 0;
  fit_.reset();
}

// Other places that explain the echoes are believed beside the doubted one, as far as the echoes speak for them.
void BayesLocator::Core::conclude_doubt() {
  doubt_ = Doubt::none;
  last_search_ = history_.end();
  Population& found = rivals_.place_for_another().population();
  search_.take(found, tools(), random_);
  double here = 0.0;
  for (Particle& p : found.particles()) {
    if (!is_doubted(p)) continue;
    here += p.weight;
    p.weight = 0.0;
  }
  const double kept = (doubted_link_ ? kLinkOdds : kDoubtedOdds) * std::max(here, kLeastHere);
  main_.resample(std::min(main_.size(), kKept), random_);
  for (Particle& p : main_.particles()) p.weight *= kept;
  for (const Particle& p : found.particles()) {
    if (p.weight > 0.0) main_.push(p);
  }
  main_.normalize();
  dismiss_others();
  if (1.0 - here < 0.5 * kept) return;  // nothing else will do
  unconfirmed_ = kConfirmed;
  fruitless_ = 0;
}

// What the wearer was told to take, while they are thought to be on the level that it leaves.
std::optional<LevelTransition> BayesLocator::Core::link_to_take() const {
  const LevelTransition* transition = links_.expected(last_time_);
  if (transition == nullptr || !building_.has_room(transition->from)) return {};
  const bool there = building_.room(estimate_.room).level == building_.room(transition->from).level;
  return there ? std::optional(*transition) : std::nullopt;
}

bool BayesLocator::Core::is_doubted(const Particle& p) const {
  if (doubted_link_) return links_.begins_near(*doubted_link_, p);
  return p.room == estimate_.room && distance(p.position, estimate_.pose.position) < kDoubted &&
         std::abs(wrap_angle(p.heading - estimate_.pose.heading)) < kDoubtedTurn;
}

}  // namespace echoway
