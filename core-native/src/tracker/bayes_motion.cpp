#include <algorithm>
#include <cmath>

#include "tracker/bayes_core.hpp"
#include "tracker/placed.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr double kPaceGain = 1.0 / 64.0;          // Per firing: four seconds of walking.
constexpr double kQuickFirings = 64.0;            // Of walking, over which a step's length is averaged at first: 4 s,
constexpr double kMostFirings = 160.0;            // and at last, once so many were heard: 10 s.
constexpr double kSharpSteps = 0.3;               // Metres: a place blurred by more does not tell how far a step led.
constexpr double kShortestStep = 0.25;            // Metres.
constexpr double kLongestStep = 1.1;
constexpr double kSharpEnough = 0.5;              // Metres: where steps are counted from.

}  // namespace

// Where several places are possible the estimate jumps between them while the wearer stands: what counts is how the
// particles move, not where the likeliest of them lie.
void BayesLocator::Core::follow_movement(const Interval& interval) {
  const double dt = interval.seconds;
  const double turn = interval.turn_known ? interval.turn_without(summary_.gyro_bias) : summary_.turn_rate * dt;
  const double turned = interval.turn_known ? std::abs(turn) : summary_.turning * dt;
  novelty_.move(std::abs(estimate_.speed_mps * dt), turned);
  pairs_.turn(turn);
}

void BayesLocator::Core::reckon_on(const Interval& interval) {
  if (!gyro_) {
    reckoning_.forget();
  } else if (reckoning_.known()) {
    reckoning_.move(interval.turn_without(summary_.gyro_bias), interval.steps * step_length_);
  }
}

// A wearer's steps are of much the same length; how fast they follow tells the pace before the echoes do.
void BayesLocator::Core::learn_pace(double time_s) {
  if (perhaps_away()) return hints_.forget_cadence();   // Treads are shorter than steps, and follow faster.
  const bool walks = summary_.walking > kSure && summary_.hypotheses[0].probability > kSure;
  const double cadence = hints_.cadence(time_s);
  if (cadence > 0.0) {
    if (walks) learn_step_length(summary_.pace / cadence);
    pace_ = std::clamp(step_length_ * cadence, 0.2, 1.8);
  } else if (walks) {
    pace_ = std::clamp(pace_ + kPaceGain * (summary_.pace - pace_), 0.2, 1.8);
  }
}

// A belief that slides off would teach a longer step, and the longer step carry it farther off.
void BayesLocator::Core::learn_step_length(double metres) {
  if (fit_.doubtful() || !(estimate_.sigma_m < kSharpSteps)) return;
  step_firings_ = std::min(step_firings_ + 1.0, kMostFirings);
  const double step = std::clamp(metres, kShortestStep, kLongestStep);
  step_length_ += (step - step_length_) / std::max(step_firings_, kQuickFirings);
}

// Steps and turns count from where the place is known well, which is given up at the first doubt.
void BayesLocator::Core::reckon_from_here() {
  if (perhaps_away()) return reckoning_.forget();
  const bool sure = estimate_.state == TrackState::tracking && estimate_.sigma_m < kSharpEnough;
  if (!gyro_ || explained_ == 0 || !sure) return;
  reckoning_.begin(place(estimate_.pose.position, estimate_.pose.heading, RoomFrame(building_, estimate_.room)));
}

// Whoever stands does not turn: what the gyroscope reads meanwhile is its bias.
void BayesLocator::Core::stand_still(double rate) {
  for_all_beliefs([&](Population& belief) { belief.observe_gyro_bias(rate, StillRate::kSigma, random_); });
}

}  // namespace echoway
