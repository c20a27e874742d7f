#include "following.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "echoway/thesis/thesis_locator.hpp"

namespace echoway::report {
namespace {

double thread_microseconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

Start start_of(const Trial& trial, const Estimator& estimator, double time_s) {
  if (estimator.told == Estimator::Told::nothing) return {};
  const auto& rows = trial.walk.truth;
  const auto at = std::lower_bound(rows.begin(), rows.end() - 1, time_s,
                                   [](const TruthRow& row, double t) { return row.time_s < t; });
  Start start;
  start.room = trial.plan.find_room(at->room);
  if (estimator.told == Estimator::Told::pose) {
    start.position = at->pose.position;
    start.heading = at->pose.heading;
  }
  return start;
}

std::unique_ptr<Locator> make(const Trial& trial, const Estimator& estimator, double time_s) {
  const BeltConfig belt = trial.walk.scans.belt.apply_to({});
  const Start start = start_of(trial, estimator, time_s);
  if (estimator.thesis) {
    auto made = make_thesis_locator(trial.plan, belt, start, estimator.parameters);
    if (!made) throw std::runtime_error(made.error().to_string());
    return std::move(*made);
  }
  BayesOptions options = estimator.bayes;
  options.seed = trial.seed;
  return std::make_unique<BayesLocator>(trial.plan, belt, start, options);
}

const TruthRow& truth_at(const sim::Simulation& walk, double time_s) {
  const auto after = std::lower_bound(walk.truth.begin(), walk.truth.end(), time_s,
                                      [](const TruthRow& row, double t) { return row.time_s < t; });
  if (after == walk.truth.begin()) return walk.truth.front();
  if (after == walk.truth.end()) return walk.truth.back();
  const auto before = after - 1;
  return time_s - before->time_s < after->time_s - time_s ? *before : *after;
}

Fix compare(const Trial& trial, const Estimate& estimate, double time_s) {
  const TruthRow& truth = truth_at(trial.walk, time_s);
  Fix fix{time_s,           estimate.room, trial.world.find_room(truth.room), Fix::kNowhere, kPi,
          estimate.sigma_m, estimate.state};
  if (estimate.room == kNoRoom) return fix;
  const Room& there = trial.world.room(fix.true_room);
  const Room& here = trial.plan.room(estimate.room);
  if (here.level != there.level) return fix;
  const Pose2 is = there.frame.compose(truth.pose);
  const Pose2 said = here.frame.compose(estimate.pose);
  fix.error_m = distance(is.position, said.position);
  fix.turn_rad = wrap_angle(said.heading - is.heading);
  return fix;
}

Track follow_until(const Trial& trial, const Estimator& estimator, std::span<const Firing> firings,
                   const std::function<bool(const Fix&)>& enough) {
  Track track;
  if (firings.empty()) return track;
  const auto locator = make(trial, estimator, firings.front().time_s);
  if (estimator.thermometer) locator->on_temperature(trial.temperature_c);
  std::size_t next = 0;
  for (const Firing& firing : firings) {
    const double begin = thread_microseconds();
    for (; next < trial.walk.motion.size() && trial.walk.motion[next].time_s <= firing.time_s; ++next) {
      const MotionHint& hint = trial.walk.motion[next];
      if (hint.kind == MotionKind::step ? estimator.steps : estimator.turns) locator->on_motion(hint);
    }
    const bool renewed = locator->on_firing(firing);
    track.firing_us.push_back(thread_microseconds() - begin);
    const Estimate& estimate = locator->estimate();
    if (estimator.thesis && !renewed) continue;
    track.fixes.push_back(compare(trial, estimate, estimator.thesis ? estimate.time_s : firing.time_s));
    if (enough && enough(track.fixes.back())) break;
  }
  return track;
}

}  // namespace

double Track::cpu_us() const {
  const double sum = std::accumulate(firing_us.begin(), firing_us.end(), 0.0);
  return firing_us.empty() ? 0.0 : sum / static_cast<double>(firing_us.size());
}

Estimator thesis_method() {
  Estimator e;
  e.name = "thesis";
  e.thesis = true;
  e.steps = e.turns = false;
  return e;
}

Estimator thesis_by_objective() {
  Estimator e = thesis_method();
  e.name = "thesis by objective";
  e.parameters.compare_by_range = false;
  return e;
}

Estimator thesis_as_printed() {
  Estimator e = thesis_method();
  e.name = "thesis as printed";
  e.parameters = ThesisParameters::as_printed();
  return e;
}

Estimator tracker() {
  Estimator e;
  e.name = "tracker";
  return e;
}

Estimator tracker_without_hints() {
  Estimator e;
  e.name = "tracker without hints";
  e.steps = e.turns = false;
  return e;
}

Track follow(const Trial& trial, const Estimator& estimator) {
  return follow(trial, estimator, trial.walk.scans.firings);
}

Track follow(const Trial& trial, const Estimator& estimator, std::span<const Firing> firings) {
  return follow_until(trial, estimator, firings, {});
}

Track follow(const Trial& trial, const Estimator& estimator, const std::function<bool(const Fix&)>& enough) {
  return follow_until(trial, estimator, trial.walk.scans.firings, enough);
}

Summary summarise(const Track& track, double from_s) {
  Summary summary;
  std::vector<double> errors;
  for (const Fix& fix : track.fixes) {
    if (fix.time_s < from_s) continue;
    errors.push_back(fix.error_m);
    summary.mean_m += fix.error_m;
    summary.turn_rad += std::abs(fix.turn_rad);
    summary.right_room += fix.right() ? 1.0 : 0.0;
    summary.within_2_sigma += fix.error_m <= 2.0 * fix.sigma_m ? 1.0 : 0.0;
  }
  const double n = std::max<double>(1.0, static_cast<double>(errors.size()));
  for (double* sum : {&summary.mean_m, &summary.turn_rad, &summary.right_room, &summary.within_2_sigma}) *sum /= n;
  summary.median_m = quantile(errors, 0.5);
  summary.p90_m = quantile(std::move(errors), 0.9);
  return summary;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

}  // namespace echoway::report
