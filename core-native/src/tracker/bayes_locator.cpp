#include "echoway/tracker/bayes_locator.hpp"

#include "tracker/bayes_core.hpp"

namespace echoway {

BayesLocator::BayesLocator(const Building& building, const BeltConfig& belt, const Start& start,
                           const BayesOptions& options)
    : core_(std::make_unique<Core>(building, belt, start, options)) {}
BayesLocator::~BayesLocator() = default;

bool BayesLocator::on_firing(const Firing& firing) { return core_->on_firing(firing); }
void BayesLocator::on_motion(const MotionHint& hint) { core_->on_motion(hint); }
void BayesLocator::on_temperature(double celsius) { core_->on_temperature(celsius); }
void BayesLocator::on_level_transition(const LevelTransition& transition) { core_->on_level_transition(transition); }
void BayesLocator::on_led(bool led) { core_->on_led(led); }
void BayesLocator::on_doubt() { core_->on_doubt(); }
const Estimate& BayesLocator::estimate() const { return core_->estimate(); }
std::span<const Hypothesis> BayesLocator::hypotheses() const {
  return {core_->summary().hypotheses.data(), static_cast<std::size_t>(core_->summary().count)};
}
std::span<const SensorSuspicion> BayesLocator::suspicions() const { return core_->suspicions(); }

}  // namespace echoway
