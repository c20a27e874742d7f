#include "echoway/tracker/bayes_locator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tracker/elementary.hpp"
#include "tracker/fit_monitor.hpp"
#include "tracker/floor.hpp"
#include "tracker/history.hpp"
#include "tracker/likelihood.hpp"
#include "tracker/motion.hpp"
#include "tracker/population.hpp"
#include "tracker/search.hpp"
#include "tracker/sensor_health.hpp"
#include "tracker/summary.hpp"

namespace echoway {

using namespace tracker;

namespace {

Shot with_full_trust(Shot shot) noexcept {
  shot.trust = 1.0;
  return shot;
}

constexpr double kStartPositionSigma = 0.30;      // Metres: what "here" means to whoever says it.
constexpr double kStartHeadingSigma = degrees(6.0);
constexpr std::size_t kSearchCapacity = 2400;
constexpr std::size_t kAlternativeCapacity = 600;
constexpr std::size_t kParticlesPerCell = 14;     // While several places are possible.
constexpr std::size_t kSettledCells = 10;         // A belief this narrow takes the tracking number of particles.
constexpr double kLongestInterval = 3.0;          // Seconds that are still walked through; longer ones are a break.
constexpr double kTemperatureSigma = 0.006;       // ln of speed: 3.5 K, a thermometer against the body.
constexpr double kNewPlace = 0.25;                // Metres ...
constexpr double kNewDirection = degrees(8.0);    // ... or a turn after which a sensor sees something else.
constexpr double kLeastNovelty = 0.20;
constexpr double kMostNovelty = 0.45;              // Even then its errors are not all new: the same cupboard, the same stride.
constexpr double kPlanExplains = 0.52;
constexpr double kShareGain = 1.0 / 24.0;
constexpr double kSurelyUnmapped = 0.6;
constexpr double kSureEnough = 0.35;               // Metres.
constexpr double kBeyondArms = 0.40;               // Metres.
constexpr double kPaceGain = 1.0 / 160.0;         // Per firing: ten seconds of walking.
constexpr std::uint64_t kRecoveryWindow = 40;     // Firings that a recovery search looks back on.
constexpr std::uint64_t kBlindRecoveryWindow = 20;   // The same without a gyroscope: a wearer hardly turns meanwhile.
constexpr double kLogNearby = -3.0;               // Prior odds that a doubtful tracker is wrong by metres,
constexpr double kLogElsewhere = -1.0;            // and that one that fits nowhere near is elsewhere.
constexpr double kCoarseHandicap = 0.05;          // Nats a firing that the search's coarse particles lose against fine ones.
constexpr double kLeastShare = 0.05;              // Alternatives that weigh less are not worth particles.
constexpr double kLocalRadius = 3.0;              // Metres.
constexpr double kLocalHeadingStep = degrees(8.0);
constexpr std::uint64_t kSearchPause = 32;        // Firings between searches.

}  // namespace

class BayesLocator::Core {
 public:
  Core(const Building& building, const BeltConfig& belt, const Start& start, const BayesOptions& options)
      : building_(building),
        belt_(belt),
        start_(start),
        options_(options),
        model_(belt, EchoModelParameters{}),
        scene_(building, model_.sight_limits()),
        random_(options.seed),
        main_(kSearchCapacity),
        alternatives_(kAlternativeCapacity),
        search_(scene_, Search::Parameters{}),
        health_(belt.sensors) {
    for (int i = 0; i < belt.sensors; ++i) {
      const double b = belt.bearing(i);
      bearings_[static_cast<std::size_t>(i)] = {std::cos(b), std::sin(b)};
    }
    log_scale_sigma_ = motion_.scale_sigma;
    begin();
  }

  bool on_firing(const Firing& firing);
  void on_motion(const MotionHint& hint) {
    hints_.on_hint(hint);
    // Only the first search takes a compass at its word: it drifts, and a search that follows a loss must not be misled.
    if (main_.empty() && hint.kind == MotionKind::heading && std::isfinite(hint.value)) compass_ = wrap_angle(hint.value);
  }
  void on_temperature(double celsius);

  Estimate estimate_;
  Summary summary_;
  SensorHealth& health() { return health_; }

 private:
  void begin();
  void place_known(const Pose2& pose, RoomIndex room, bool heading_known);
  void describe_ignorance();
  [[nodiscard]] Search::Tools tools() const;
  [[nodiscard]] Shot aim(const Record& record) const;
  double update(Population& population, const Record& record, const HintIntegrator::GaitEvidence& gait);
  void thin_out(Population& population);
  [[nodiscard]] std::span<const Spot> recall(const Shot& shot);
  void remember(const Record& record);
  [[nodiscard]] double novelty(int sensor, const Interval& interval);
  void pursue_search();
  void consider_alternatives();
  void conclude(double time_s);

  const Building& building_;
  BeltConfig belt_;
  Start start_;
  BayesOptions options_;
  EchoModel model_;
  mutable scene::Scene scene_;
  MotionParameters motion_;
  Random random_;
  Population main_;
  Population alternatives_;
  Search search_;
  SensorHealth health_;
  History history_;
  HintIntegrator hints_;
  FitMonitor fit_;
  EchoMemory memory_;
  double mapped_share_ = 0.7;       ///< Of recent echoes that something in the plan explains.
  double unmapped_ = 0.0;           ///< Probability that the last echo came from nothing in the plan.
  std::array<Vec2, kMaxSensors> bearings_{};

  struct Visit {
    bool made = false;
    double travelled = 0.0;
    double turned = 0.0;
  };
  std::array<Visit, kMaxSensors> visits_{};   ///< How far the wearer had come when each sensor last fired.
  double travelled_ = 0.0;
  double turned_ = 0.0;
  double last_heading_ = 0.0;
  std::optional<double> compass_;        // what it said last before the first search, in the levels' frames

  bool clock_set_ = false;
  double last_time_ = 0.0;
  int backwards_ = 0;
  bool gyro_ = false;
  double pace_ = 0.55;              ///< Usual walking speed, learnt.
  double log_scale_ = 0.0;
  double log_scale_sigma_ = 0.0;
  bool local_failed_ = false;
  std::uint64_t no_search_before_ = 0;
};

void BayesLocator::Core::begin() {
  if (start_.room && (*start_.room < 0 || *start_.room >= static_cast<RoomIndex>(building_.rooms.size()))) start_ = {};
  if (start_.room && start_.position && is_finite(*start_.position)) {
    const bool heading_known = start_.heading && std::isfinite(*start_.heading);
    place_known({*start_.position, heading_known ? wrap_angle(*start_.heading) : 0.0}, *start_.room, heading_known);
  }
  describe_ignorance();
}

void BayesLocator::Core::place_known(const Pose2& pose, RoomIndex room, bool heading_known) {
  const std::size_t count = heading_known ? 400 : 1800;
  for (std::size_t i = 0; i < count; ++i) {
    Particle p;
    p.weight = 1.0 / static_cast<double>(count);
    p.room = room;
    p.position = pose.position;
    const double share = (static_cast<double>(i) + random_.uniform()) / static_cast<double>(count);
    p.heading = heading_known ? wrap_near(pose.heading + kStartHeadingSigma * cheap_normal(random_)) : kTwoPi * share - kPi;
    const SinCos f = fast_sincos(p.heading);
    p.facing = {f.cos, f.sin};
    p.speed = i % 2 == 0 ? pace_ : 0.0;
    p.gait = i % 2 == 0 ? Gait::walking : Gait::standing;
    p.gyro_bias = motion_.gyro_bias_sigma * cheap_normal(random_);
    p.turn_rate = motion_.straight_sigma * cheap_normal(random_);
    p.cov.xx = p.cov.yy = kStartPositionSigma * kStartPositionSigma;
    p.cov.ss = i % 2 == 0 ? 0.2 * 0.2 : motion_.standing_sigma * motion_.standing_sigma;
    p.cov.kk = motion_.scale_sigma * motion_.scale_sigma;
    main_.push(p);
  }
  conclude(0.0);
}

// Before anything is heard: the start's room, or the largest one, and how little that says.
void BayesLocator::Core::describe_ignorance() {
  if (!main_.empty()) return;
  double total = 0.0, largest = 0.0;
  RoomIndex room = kNoRoom;
  for (std::size_t i = 0; i < building_.rooms.size(); ++i) {
    const auto& r = scene_.room(static_cast<RoomIndex>(i));
    const double area = (r.high.x - r.low.x) * (r.high.y - r.low.y);
    total += area;
    if (area > largest) {
      largest = area;
      room = static_cast<RoomIndex>(i);
    }
  }
  if (start_.room) room = *start_.room;
  if (room == kNoRoom) return;
  const auto& r = scene_.room(room);
  estimate_.room = room;
  estimate_.pose = {0.5 * (r.low + r.high), start_.heading.value_or(0.0)};
  estimate_.sigma_m = 0.3 * distance(r.low, r.high);
  estimate_.covariance_xx = estimate_.covariance_yy = estimate_.sigma_m * estimate_.sigma_m;
  estimate_.sigma_heading_rad = start_.heading ? kStartHeadingSigma : kPi / std::sqrt(3.0);
  estimate_.room_probability = start_.room ? 0.99 : largest / std::max(total, 1e-9);
  estimate_.state = TrackState::searching;
  summary_.count = 1;
  summary_.hypotheses[0] = {estimate_.room, estimate_.pose, estimate_.sigma_m, estimate_.room_probability};
}

Search::Tools BayesLocator::Core::tools() const {
  return {model_, scene_, motion_, belt_, history_, building_, log_scale_, std::max(log_scale_sigma_, 0.004), main_.empty() ? 0.0 : summary_.gyro_bias};
}

Shot BayesLocator::Core::aim(const Record& record) const {
  Shot shot;
  shot.bearing = bearings_[static_cast<std::size_t>(record.sensor)];
  shot.bearing_rad = belt_.bearing(record.sensor);
  shot.radius = belt_.radius_m;
  shot.range = record.range;
  shot.echo = record.echo;
  shot.trust = record.trust;
  return shot;
}

// Predicts, weighs and corrects every particle; returns the log density of the reading.
double BayesLocator::Core::update(Population& population, const Record& record, const HintIntegrator::GaitEvidence& gait) {
  Shot shot = aim(record);
  const bool tracked = &population == &main_ && record.echo && estimate_.state == TrackState::tracking;
  // A lost tracker would explain everything by furniture: memory serves only while the plan explains most echoes.
  if (tracked && mapped_share_ > kPlanExplains) shot.spots = recall(shot);
  double heard_mapped = 0.0;
  double before = 0.0;
  for (Particle& p : population.particles()) {
    advance(p, record.interval, motion_, pace_, random_);
    p.weight *= p.gait == Gait::walking ? gait.walking : gait.standing;
    before += p.weight;
    if (record.trust > 0.0 || tracked) {
      if (record.trust <= 0.0) {
        Particle untouched = p;
        heard_mapped += p.weight * assimilate(untouched, with_full_trust(shot), model_, scene_).mapped;
        p.weight *= settle_on_floor(p, scene_);
        continue;
      }
      const Outcome outcome = assimilate(p, shot, model_, scene_);
      heard_mapped += p.weight * outcome.mapped;
      p.weight *= record.novelty < 1.0 ? fast_exp(record.novelty * fast_log(outcome.density)) : outcome.density;
    }
    p.weight *= settle_on_floor(p, scene_);
  }
  unmapped_ = tracked && before > 0.0 ? 1.0 - heard_mapped / before : 0.0;
  if (tracked && before > 0.0 && record.range > kBeyondArms) mapped_share_ += kShareGain * (1.0 - unmapped_ - mapped_share_);
  return fast_log(population.normalize()) - fast_log(before);
}

// Furniture, soft walls and people make a resting sensor repeat its error. Only a sensor that has been moved or turned
// since it last fired tells something new.
double BayesLocator::Core::novelty(int sensor, const Interval& interval) {
  travelled_ += std::abs(estimate_.speed_mps) * interval.seconds;
  turned_ += interval.turn_known ? std::abs(interval.turn) : std::abs(wrap_angle(estimate_.pose.heading - last_heading_));
  last_heading_ = estimate_.pose.heading;
  Visit& visit = visits_[static_cast<std::size_t>(sensor)];
  const double moved = (travelled_ - visit.travelled) / kNewPlace + (turned_ - visit.turned) / kNewDirection;
  const bool first = !visit.made;
  visit = {true, travelled_, turned_};
  return first || main_.empty() ? 1.0 : std::clamp(moved, kLeastNovelty, kMostNovelty);
}

std::span<const Spot> BayesLocator::Core::recall(const Shot& shot) {
  const Vec2 axis = unit_from_angle(estimate_.pose.heading + shot.bearing_rad);
  return memory_.recall(estimate_.room, estimate_.pose.position + shot.radius * axis, axis, shot.range * estimate_.sound_speed_scale);
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
  const auto settled = static_cast<std::size_t>(gyro_ ? options_.particles : options_.particles_without_gyroscope);
  const double n = static_cast<double>(population.size());
  const bool shrink = population.size() > settled + settled / 4;
  const double effective = population.effective_size();
  if (effective > 0.5 * n && !(shrink && history_.end() % 4 == 0)) return;
  const std::size_t cells = population.occupied_cells();
  std::size_t target = settled;
  if (cells > kSettledCells) target = std::max(settled, kParticlesPerCell * cells);
  target = std::max(target, static_cast<std::size_t>(fit_.doubt() * static_cast<double>(settled)));
  target = std::min(target, population.capacity());
  if (effective > 0.5 * n && target >= population.size()) return;
  population.resample(target, random_);
}

bool BayesLocator::Core::on_firing(const Firing& firing) {
  if (firing.sensor < 0 || firing.sensor >= belt_.sensors || !std::isfinite(firing.time_s) || std::isnan(firing.range_m)) return false;
  double dt = clock_set_ ? firing.time_s - last_time_ : 0.0;
  if (dt < 0.0) {
    // One late row is dropped; a clock that was set back is followed.
    if (++backwards_ < 2 * belt_.sensors) return false;
    dt = belt_.slot_s;
    hints_.reset_clock();
  }
  backwards_ = 0;
  clock_set_ = true;
  last_time_ = firing.time_s;

  Record record;
  record.interval = hints_.close(firing.time_s, std::min(dt, kLongestInterval));
  record.sensor = firing.sensor;
  record.echo = firing.has_echo() && firing.range_m < belt_.max_range_m * 1.1;
  record.range = std::max(firing.range_m, 0.01);
  record.trust = health_.trust(firing.sensor, record.echo);
  record.novelty = novelty(firing.sensor, record.interval);
  gyro_ = record.interval.turn_known;
  history_.push(record);

  const auto gait = hints_.take_gait_evidence(firing.time_s, record.interval.seconds);
  if (!main_.empty()) {
    const double log_main = update(main_, record, gait);
    history_.back().log_main = log_main;
    if (record.trust > 0.5) fit_.observe(log_main, record.echo, record.range);
  }
  pursue_search();
  if (!main_.empty()) thin_out(main_);
  conclude(firing.time_s);
  remember(record);
  const double progress = travelled_ / kNewPlace + turned_ / kNewDirection;
  health_.judge(record.sensor, record.echo, record.range, progress,
                estimate_.state == TrackState::tracking && !fit_.doubtful() ? unmapped_ : 0.0);
  return true;
}

// Searches when nothing is known yet, round about when the echoes fit less well than they used to, and the whole building
// when they do not fit and nothing near does better.
void BayesLocator::Core::pursue_search() {
  const std::uint64_t now = history_.end();
  if (!search_.running()) {
    const auto pass = static_cast<std::uint64_t>(std::clamp(belt_.sensors, 8, 24));
    if (main_.empty()) {
      if (now < pass) return;
      SearchDomain domain;
      if (start_.room) domain.only_room = *start_.room;
      if (start_.room && start_.heading) {
        domain.heading = *start_.heading;
      } else {
        domain.level_heading = compass_;
      }
      domain.heading_sigma = kStartHeadingSigma;
      search_.start(domain, now - pass, now);
    } else {
      if (now < no_search_before_ || now < kRecoveryWindow || !fit_.doubtful()) return;
      SearchDomain domain;
      domain.near_room = estimate_.room;
      domain.near_position = estimate_.pose.position;
      const bool everywhere = fit_.poor() && local_failed_;
      if (!everywhere) domain.within = kLocalRadius;
      if (!everywhere && gyro_) domain.near_heading = estimate_.pose.heading;
      domain.heading_sigma = kLocalHeadingStep;
      search_.start(domain, now - (gyro_ ? kRecoveryWindow : kBlindRecoveryWindow), now);
    }
  }
  if (!search_.work(tools())) return;
  if (main_.empty()) {
    search_.take(main_, random_, motion_);
    fit_.reset();
    return;
  }
  consider_alternatives();
}

// Mixes what the search found into the belief, by the odds that it explains the same firings better.
void BayesLocator::Core::consider_alternatives() {
  const std::uint64_t now = history_.end();
  double log_main = 0.0;
  for (std::uint64_t n = search_.window_begin(); n < now; ++n) log_main += history_[n].log_main;
  const double odds = search_.log_evidence() - log_main + kCoarseHandicap * static_cast<double>(now - search_.window_begin()) + (search_.is_local() ? kLogNearby : kLogElsewhere);
  const double share = 1.0 / (1.0 + fast_exp(-odds));
  no_search_before_ = now + kSearchPause;
  local_failed_ = search_.is_local() && share < 0.5;
  if (share < kLeastShare) {
    search_.stop();
    return;
  }
  search_.take(alternatives_, random_, motion_);
  if (main_.size() + alternatives_.size() > main_.capacity()) main_.resample(main_.capacity() - alternatives_.size(), random_);
  for (Particle& p : main_.particles()) p.weight *= 1.0 - share;
  for (Particle& p : alternatives_.particles()) {
    p.weight *= share;
    main_.push(p);
  }
  alternatives_.clear();
  if (share < 0.5) return;
  memory_.clear();
  mapped_share_ = 0.7;
  fit_.reset();
}

void BayesLocator::Core::on_temperature(double celsius) {
  if (!(celsius > -40.0 && celsius < 60.0)) return;
  // Sound that is faster than assumed makes ranges come out short.
  const double log_scale = std::log(speed_of_sound(belt_.temperature_c) / speed_of_sound(celsius));
  if (main_.empty()) {
    log_scale_ = log_scale;
    log_scale_sigma_ = kTemperatureSigma;
    return;
  }
  for (Particle& p : main_.particles()) {
    if (p.cov.kk > kTemperatureSigma * kTemperatureSigma) observe_log_scale(p, log_scale, kTemperatureSigma * kTemperatureSigma);
  }
}

void BayesLocator::Core::conclude(double time_s) {
  estimate_.time_s = time_s;
  if (main_.empty()) return;
  summary_ = summarize(main_.particles(), building_, SummaryParameters{});
  estimate_ = summary_.best;
  estimate_.time_s = time_s;
  if (summary_.walking > 0.9 && summary_.hypotheses[0].probability > 0.9) {
    pace_ = std::clamp(pace_ + kPaceGain * (summary_.pace - pace_), 0.2, 1.8);
  }
  log_scale_ = summary_.log_scale;
  log_scale_sigma_ = std::max(summary_.log_scale_sigma, 0.004);
  const double probability = summary_.hypotheses[0].probability;
  if (fit_.poor()) {
    estimate_.state = TrackState::lost;
  } else if (probability > 0.9 && estimate_.sigma_m < 1.0) {
    estimate_.state = TrackState::tracking;
  } else {
    estimate_.state = TrackState::searching;
  }
}

BayesLocator::BayesLocator(const Building& building, const BeltConfig& belt, const Start& start, const BayesOptions& options)
    : core_(std::make_unique<Core>(building, belt, start, options)) {}
BayesLocator::~BayesLocator() = default;

bool BayesLocator::on_firing(const Firing& firing) { return core_->on_firing(firing); }
void BayesLocator::on_motion(const MotionHint& hint) { core_->on_motion(hint); }
void BayesLocator::on_temperature(double celsius) { core_->on_temperature(celsius); }
const Estimate& BayesLocator::estimate() const { return core_->estimate_; }
std::span<const Hypothesis> BayesLocator::hypotheses() const {
  return {core_->summary_.hypotheses.data(), static_cast<std::size_t>(core_->summary_.count)};
}
std::span<const SensorSuspicion> BayesLocator::suspicions() const { return core_->health().suspicions(); }

}  // namespace echoway
