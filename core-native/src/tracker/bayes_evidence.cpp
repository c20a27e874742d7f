#include "tracker/bayes_core.hpp"
#include "tracker/between_levels.hpp"
#include "tracker/stillness.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr double kWorthHeeding = 0.1;   // Probability that something in no plan answered: less would move nobody.

}  // namespace

BayesLocator::Core::Evidence BayesLocator::Core::take_evidence(const Record& record, double time_s) {
  Evidence evidence{hints_.take_gait_evidence(time_s, record.interval.seconds)};
  if (!record.echo || !gyro_) return evidence;
  const auto pair = pairs_.hear(record.sensor, record.range, time_s);
  if (!pair) return evidence;
  evidence.still = stillness(*pair, pace_);
  if (options_.parts.range_rate) {
    evidence.speed = speed_by_range_rate(*pair, bearings_[static_cast<std::size_t>(record.sensor)], pace_);
  }
  return evidence;
}

// What the plan explains has been weighed by place: along a plain wall who walks hears the same again as well. Who
// rides an elevator stands, too, and hears the cabin again and again.
void BayesLocator::Core::heed_pair(Population& population, const Evidence& evidence, double unexplained) const {
  if (!evidence.still || unexplained <= 0.0) return;
  const double still = tempered(*evidence.still, unexplained);
  const bool moves = evidence.speed && unexplained > kWorthHeeding;
  for (Particle& p : population.particles()) {
    const bool rides = p.gait == Gait::away && !links_.on_stairs(p);
    if (rides || p.gait == Gait::standing) p.weight *= still;
    if (moves && p.gait == Gait::walking) p.weight *= heed(p, *evidence.speed, unexplained);
  }
}

Outcome BayesLocator::Core::hear_away(Particle& p, const Shot& shot, double anywhere) const {
  if (shot.trust <= 0.0) return {anywhere, anywhere, 0.0};
  const double there = links_.on_stairs(p) ? on_stairs(shot, fit_.echo_share()) : in_cabin(shot);
  return hear_in_no_room(p, shot, *model_, shot.trust * there + (1.0 - shot.trust) * anywhere);
}

}  // namespace echoway
