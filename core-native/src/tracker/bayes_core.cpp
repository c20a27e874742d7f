#include "tracker/bayes_core.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/association.hpp"
#include "tracker/elementary.hpp"
#include "tracker/floor.hpp"
#include "tracker/particle_need.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr double kShareBetween = 0.15;            // Of the evidence between places that lie apart: what is in no plan
                                                  // speaks for one of two alike as long as it is heard. Without a
constexpr double kShareBetweenBlind = 0.85;       // gyroscope every turn tried makes a place, and must be over soon.
constexpr double kShareBetweenLevels = 0.5;       // Who is away shall be found soon after they have arrived.
constexpr double kUnhurried = 0.6;                // m/s; who walks faster goes farther between two looks of a sensor.
constexpr double kNarrow = 0.15;                  // Metres: a place known so well takes the fewest particles,
constexpr double kMostNeeded = 2.5;               // another one so many times as many at most.
constexpr std::uint64_t kSilence = 32;            // Firings without an echo that count as one.
constexpr double kLongestInterval = 3.0;          // Seconds that are still walked through; longer ones are a break.
constexpr double kTemperatureSigma = 0.006;       // ln of speed: 3.5 K, a thermometer against the body.
constexpr double kPlanExplains = 0.52;
constexpr double kShareGain = 1.0 / 24.0;
constexpr double kCoatRange = 0.5;                // Metres: two passes of nearer echoes come from what covers the belt.
constexpr double kSurelyUnmapped = 0.6;
constexpr double kSureEnough = 0.35;              // Metres.
constexpr double kSharp = 1.0;                    // Metres: the standard deviation up to which a place is tracked.

}  // namespace

void BayesLocator::Core::on_motion(const MotionHint& hint) {
  hints_.on_hint(hint);
  // Only the first searches take a compass at its word: it drifts, and a search that follows a loss must not be misled.
  if ((main_.empty() || unconfirmed_ > 0) && hint.kind == MotionKind::heading && std::isfinite(hint.value)) {
    compass_ = wrap_angle(hint.value);
    compass_said_ = history_.end();
  }
}

void BayesLocator::Core::on_temperature(double celsius) {
  if (!options_.parts.sound_speed || !(celsius > -40.0 && celsius < 60.0)) return;
  // Sound that is faster than assumed makes ranges come out short.
  const double log_scale = std::log(speed_of_sound(belt_.temperature_c) / speed_of_sound(celsius));
  if (main_.empty()) {
    log_scale_ = log_scale;
    log_scale_sigma_ = kTemperatureSigma;
    return;
  }
  constexpr double kVariance = kTemperatureSigma * kTemperatureSigma;
  for_all_beliefs([&](Population& belief) {
    for (Particle& p : belief.particles()) {
      if (p.cov.kk > kVariance) observe_log_scale(p, log_scale, kVariance);
    }
  });
}

bool BayesLocator::Core::on_firing(const Firing& firing) {
  if (firing.sensor < 0 || firing.sensor >= belt_.sensors) return false;
  if (!std::isfinite(firing.time_s) || std::isnan(firing.range_m)) return false;
  double seconds = 0.0;
  if (!tell_time(firing.time_s, seconds)) return false;
  history_.push(take_down(firing, seconds));
  Record& record = history_.back();
  near_in_a_row_ = record.echo && record.range < kCoatRange ? near_in_a_row_ + 1 : 0;
  if (covered()) record.trust = 0.0;

  if (const auto rate = hints_.take_still_rate()) stand_still(*rate);
  const Evidence evidence = take_evidence(record, firing.time_s);
  record.gait = evidence.gait;
  if (!main_.empty()) track(record, evidence);
  choose_model(record);
  pursue_search();
  for_all_beliefs([&](Population& belief) { thin_out(belief); });
  conclude(firing.time_s);
  remember(record);
  if (record.echo && record.trust > 0.0) repeats_.note(record.sensor, record.range, last_time_);
  const bool certain = estimate_.state == TrackState::tracking && !fit_.doubtful();
  health_.judge(record.sensor, record.echo, record.range, novelty_.progress(), certain ? unmapped_ : 0.0);
  return true;
}

// One late row is dropped; a clock that was set back is followed.
bool BayesLocator::Core::tell_time(double time_s, double& seconds) {
  seconds = clock_set_ ? time_s - last_time_ : 0.0;
  if (seconds < 0.0) {
    if (++backwards_ < 2 * belt_.sensors) return false;
    seconds = belt_.slot_s;
    hints_.set_clock_back(time_s);
  }
  backwards_ = 0;
  clock_set_ = true;
  last_time_ = time_s;
  return true;
}

Record BayesLocator::Core::take_down(const Firing& firing, double seconds) {
  Record record;
  record.interval = hints_.close(firing.time_s, std::min(seconds, kLongestInterval));
  record.sensor = firing.sensor;
  record.echo = firing.has_echo() && firing.range_m < belt_.max_range_m * 1.1;
  record.range = std::max(firing.range_m, 0.01);
  record.trust = health_.trust(firing.sensor, record.echo);
  if (!options_.parts.silence && !record.echo) record.trust = 0.0;
  gyro_ = record.interval.turn_known;
  blind_for_ = gyro_ ? 0 : blind_for_ + 1;
  follow_movement(record.interval);
  reckon_on(record.interval);
  const double novelty = novelty_.of(firing.sensor);
  record.novelty = options_.parts.novelty && !main_.empty() ? novelty : 1.0;
  return record;
}

Shot BayesLocator::Core::aim(const Record& record) const {
  return shot_of(record, belt_, bearings_[static_cast<std::size_t>(record.sensor)]);
}

// One firing for the belief, and for its understudy and its rivals if there are any.
void BayesLocator::Core::track(Record& record, const Evidence& evidence) {
  Shot shot = aim(record);
  const bool tracked = record.echo && estimate_.state == TrackState::tracking;
  if (record.echo && options_.parts.repeats) {
    shot.repeats = repeats_.match(record.sensor, record.range, last_time_);
  }
  Shot remembering = shot;
  // A lost tracker would explain everything by furniture: memory serves only while the plan explains most echoes.
  if (tracked && options_.parts.memory && mapped_share_ > kPlanExplains) remembering.spots = recall(shot);
  const Verdict verdict = update(main_, record, evidence, remembering);
  unmapped_ = tracked ? 1.0 - verdict.mapped : 0.0;
  if (tracked && record.range > kBeyondArms) mapped_share_ += kShareGain * (verdict.mapped - mapped_share_);
  record.log_main = record.novelty * verdict.log_plan;
  show(fit_, verdict, record);
  follow_understudy(record, evidence, remembering);
  judge_rivals(record, evidence, shot);
}

// Between levels the echoes fit no place, which says nothing against the place that was left.
void BayesLocator::Core::show(FitMonitor& fit, const Verdict& verdict, const Record& record) const noexcept {
  if (shows_fit(record) && !perhaps_away()) fit.observe(verdict.log_plan, record.echo, record.range);
}

// Predicts, weighs and corrects every particle.
BayesLocator::Core::Verdict BayesLocator::Core::update(Population& population, const Record& record,
                                                       const Evidence& evidence, const Shot& shot) {
  double mapped = 0.0;
  double plan = 0.0;
  double before = 0.0;
  const double anywhere = record.trust > 0.0 ? fit_.anywhere(record.echo, record.range) : 1.0;
  population.weigh_modes();
  const Stride stride(record.interval, motion_, pace_, evidence.gait);
  for (Particle& p : population.particles()) {
    const bool was_away = p.gait == Gait::away;
    stride.advance(p, random_);
    if (!links_.none()) links_.step(p, last_time_, record.interval.seconds, record.interval.turn_known, random_);
    if (was_away) {   // The others have been weighed by the stride.
      p.weight *= evidence.gait.of(p.gait == Gait::walking || (p.gait == Gait::away && links_.on_stairs(p)));
    }
    before += p.weight;
    if (p.gait == Gait::away) {
      const Outcome outcome = hear_away(p, shot, anywhere);
      plan += p.weight * outcome.plan;
      p.weight *= tempered(outcome.density, record.novelty);
      continue;
    }
    if (record.trust > 0.0) {
      const Outcome outcome = assimilate(p, shot, *model_, scene_, random_);
      mapped += p.weight * outcome.mapped;
      plan += p.weight * outcome.plan;
      p.weight *= tempered(outcome.density, record.novelty);
    } else {
      plan += p.weight;
      // A suspect sensor moves nothing, but whether the plan explains it again must be known to acquit it.
      if (record.echo) mapped += p.weight * mapped_share_of(p, shot);
    }
    p.weight *= settle_on_floor(p, scene_);
  }
  const double explained = before > 0.0 ? mapped / before : 0.0;
  heed_pair(population, evidence, std::max(record.trust - explained, 0.0));
  population.temper_modes(!gyro_ ? kShareBetweenBlind : perhaps_away() ? kShareBetweenLevels : kShareBetween);
  population.normalize();
  if (!(before > 0.0)) return {};
  return {fast_log(plan) - fast_log(before), explained};
}

double BayesLocator::Core::mapped_share_of(const Particle& p, Shot shot) {
  shot.trust = 1.0;
  return weigh(p, shot, *model_, scene_).mapped;
}

std::span<const Spot> BayesLocator::Core::recall(const Shot& shot) {
  const Vec2 axis = unit_from_angle(estimate_.pose.heading + shot.bearing_rad);
  const double range = shot.range * estimate_.sound_speed_scale;
  return memory_.recall(estimate_.room, estimate_.pose.position + shot.radius * axis, axis, range);
}

// What answered though the plan has nothing there is remembered where the wearer's place is well known.
void BayesLocator::Core::remember(const Record& record) {
  if (!record.echo || unmapped_ < kSurelyUnmapped || estimate_.state != TrackState::tracking) return;
  if (estimate_.sigma_m > kSureEnough || record.range < kBeyondArms) return;
  const Shot shot = aim(record);
  const Vec2 axis = unit_from_angle(estimate_.pose.heading + shot.bearing_rad);
  const double reach = shot.radius + record.range * estimate_.sound_speed_scale;
  memory_.note(estimate_.room, estimate_.pose.position + reach * axis, unmapped_, estimate_.time_s);
}

void BayesLocator::Core::thin_out(Population& population) {
  const double need = std::clamp(std::max(pace_ / kUnhurried, estimate_.sigma_m / kNarrow), 1.0, kMostNeeded);
  const int all = options_.particles_without_gyroscope;
  const int blind = understudy_.present() ? (all + 1) / 2 : all;
  const auto settled = static_cast<std::size_t>(gyro_ ? need * options_.particles : blind);
  const std::size_t size = population.main_size();
  const bool shrink = size > settled + settled / 4;
  const bool worn = population.least_effective_share() <= 0.5;
  if (!worn && !(shrink && history_.end() % 4 == 0)) return;
  const bool silent = echoes_since(history_.end() - std::min(history_.end(), kSilence)) == 0;
  const ParticleNeed belief{settled, population.occupied_cells(), fit_.doubt(), perhaps_away(), silent};
  const std::size_t target = particles_needed(belief, population.capacity());
  if (!worn && target >= size) return;
  resample(population, target);
}

// The belief and its understudy keep every place that is possible; a rival stands for one.
void BayesLocator::Core::resample(Population& population, std::size_t target) {
  const auto by_places = [&](const Summary& places) {
    modes_.resample(population, places, building_, target, !gyro_, random_);
  };
  if (options_.parts.modes && &population == &main_) {
    by_places(summary_);
  } else if (options_.parts.modes && &population == &understudy_.population()) {
    by_places(summarize(population.particles(), building_, SummaryParameters{}));
  } else {
    population.resample(target, random_);
  }
}

int BayesLocator::Core::echoes_since(std::uint64_t firing) const {
  int echoes = 0;
  for (std::uint64_t n = firing; n < history_.end(); ++n) echoes += history_[n].echo && history_[n].trust > 0.0;
  return echoes;
}

void BayesLocator::Core::conclude(double time_s) {
  estimate_.time_s = time_s;
  if (main_.empty()) return;
  summary_ = summarize(main_.particles(), building_, SummaryParameters{});
  estimate_ = summary_.best;
  estimate_.time_s = time_s;
  learn_pace(time_s);
  if (!fit_.doubtful()) {   // Readings that fit nowhere bend the scale first of all; a search must not inherit that.
    log_scale_ = summary_.log_scale;
    log_scale_sigma_ = std::max(summary_.log_scale_sigma, kLeastScaleSigma);
  }
  if (!links_.none()) {
    see_who_is_away();
    levels_.observe(main_.particles(), links_, history_.end() == 0 ? 0.0 : history_.back().interval.seconds);
  }
  estimate_.state = state();
  poor_for_ = fit_.poor() ? poor_for_ + 1 : 0;
  explained_ = fit_.doubtful() || unconfirmed_ > 0 ? 0 : explained_ + 1;
  if (explained_ > kConfirmed) fruitless_ = 0;
  reckon_from_here();
  if (unconfirmed_ > 0) {
    unconfirmed_ = fit_.doubtful() ? kConfirmed : unconfirmed_ - (estimate_.state == TrackState::tracking);
  }
}

void BayesLocator::Core::see_who_is_away() {
  away_ = 0.0;
  double heaviest = 0.0;
  for (const Particle& p : main_.particles()) {
    if (p.gait != Gait::away) continue;
    away_ += p.weight;
    if (p.weight <= heaviest) continue;
    heaviest = p.weight;
    landing_ = links_.landing(p, searches_);
  }
}

TrackState BayesLocator::Core::state() const {
  if (away_ > kSurelyAway || covered()) return TrackState::searching;
  if (fit_.poor()) return TrackState::lost;
  const bool tracking = summary_.hypotheses[0].probability > kSure && estimate_.sigma_m < kSharp;
  return tracking ? TrackState::tracking : TrackState::searching;
}

}  // namespace echoway
