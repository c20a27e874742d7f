#include <algorithm>
#include <cmath>

#include "tracker/bayes_core.hpp"
#include "tracker/elementary.hpp"
#include "tracker/floor.hpp"

namespace echoway {

using namespace tracker;

namespace {

constexpr double kHere = 0.10;                    // Metres: what "here" means to half of those who say their heading,
constexpr double kHereabouts = 0.30;              // and to the others.
constexpr double kStartHeadingSigma = degrees(6.0);
constexpr double kStartSpeedSigma = 0.2;          // Metres a second, of one who walks.
constexpr std::size_t kFacing = 400;              // Particles of a start whose heading is known,
constexpr std::size_t kAllRound = 1800;           // and of one whose heading is not.
constexpr std::size_t kCapacity = 2400;
constexpr std::size_t kMostRivals = 2;
constexpr std::size_t kRivalCapacity = 600;
constexpr std::size_t kUnderstudyCapacity = 1200;

EchoModelParameters echo_parameters(const TrackerParts& parts) {
  EchoModelParameters p;
  if (!parts.furniture) p.furnished = 0.0;
  if (!parts.rough_walls) p.rough = 0.0;
  if (!parts.mirrored_corners) p.detect_mirrored = 0.0;
  return p;
}

MotionParameters motion_parameters(const TrackerParts& parts) {
  MotionParameters p;
  if (!parts.sound_speed) p.scale_sigma = p.scale_drift = 1e-6;
  return p;
}

// With a gyroscope a place that is kept in mind takes no more than the one that is tracked.
Modes::Parameters mode_parameters(const BayesOptions& options) {
  Modes::Parameters p;
  p.fewest = std::min(p.fewest, static_cast<std::size_t>(std::max(options.particles, 1)));
  return p;
}

}  // namespace

BayesLocator::Core::Core(const Building& building, const BeltConfig& belt, const Start& start,
                         const BayesOptions& options)
    : building_(building),
      belt_(belt),
      start_(start),
      options_(options),
      keen_(belt, echo_parameters(options.parts)),
      wary_(belt, wary(echo_parameters(options.parts))),
      deafened_(belt, hard_of_hearing(echo_parameters(options.parts))),
      scene_(building, keen_.sight_limits()),
      motion_(motion_parameters(options.parts)),
      random_(options.seed),
      main_(kCapacity),
      modes_(kCapacity, mode_parameters(options)),
      rivals_(kMostRivals, kRivalCapacity),
      understudy_(kUnderstudyCapacity),
      search_(scene_, Search::Parameters{}),
      health_(belt.sensors),
      links_(building),
      levels_(building),
      mapped_share_(kUsuallyMapped),
      log_scale_sigma_(motion_.scale_sigma) {
  for (int i = 0; i < belt.sensors; ++i) {
    bearings_[static_cast<std::size_t>(i)] = unit_from_angle(belt.bearing(i));
  }
  begin();
}

void BayesLocator::Core::begin() {
  if (start_.room && !building_.has_room(*start_.room)) start_ = {};
  if (start_.heading && !std::isfinite(*start_.heading)) start_.heading.reset();
  if (start_.room) levels_.begin_in(*start_.room);
  if (start_.heading) start_.heading = wrap_angle(*start_.heading);  // Whoever says it may have counted the turns.
  if (start_.room && start_.position && can_stand(scene_.room(*start_.room), *start_.position)) {
    place_known({*start_.position, start_.heading.value_or(0.0)}, *start_.room, start_.heading.has_value());
  }
  describe_ignorance();
}

void BayesLocator::Core::place_known(const Pose2& pose, RoomIndex room, bool heading_known) {
  const std::size_t count = heading_known ? kFacing : kAllRound;
  for (std::size_t i = 0; i < count; ++i) {
    Particle p;
    p.weight = 1.0 / static_cast<double>(count);
    p.room = room;
    p.position = pose.position;
    const double share = (static_cast<double>(i) + random_.uniform()) / static_cast<double>(count);
    p.heading = kTwoPi * share - kPi;
    if (heading_known) p.heading = wrap_near(pose.heading + kStartHeadingSigma * cheap_normal(random_));
    face_heading(p);
    const bool walks = i % 2 == 0;
    p.gait = walks ? Gait::walking : Gait::standing;
    p.speed = !walks ? 0.0 : i % 4 == 0 ? pace_ : random_.uniform(motion_.slowest_pace, motion_.fastest_pace);
    p.gyro_bias = motion_.gyro_bias_sigma * cheap_normal(random_);
    p.turn_rate = motion_.straight_sigma * cheap_normal(random_);
    const bool exact = heading_known && (i / 4) % 2 == 0;   // Of each gait and pace one half.
    const double sigma = exact ? kHere : kHereabouts;
    p.cov.xx = p.cov.yy = sigma * sigma;
    p.cov.ss = walks ? kStartSpeedSigma * kStartSpeedSigma : motion_.standing_sigma * motion_.standing_sigma;
    p.cov.kk = motion_.scale_sigma * motion_.scale_sigma;
    main_.push(p);
  }
  hearing_test_ = HearingTest::done;
  conclude(0.0);
}

// Before anything is heard: the start's room, or the largest one, and how little that says.
void BayesLocator::Core::describe_ignorance() {
  if (!main_.empty()) return;
  double total = 0.0, largest = 0.0;
  RoomIndex room = kNoRoom;
  for (std::size_t i = 0; i < building_.rooms.size(); ++i) {
    const double area = scene_.room(static_cast<RoomIndex>(i)).box_area();
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
  estimate_.pose = {0.5 * (r.low + r.high), wrap_angle(start_.heading.value_or(0.0))};
  estimate_.sigma_m = 0.3 * distance(r.low, r.high);
  estimate_.covariance_xx = estimate_.covariance_yy = estimate_.sigma_m * estimate_.sigma_m;
  estimate_.sigma_heading_rad = start_.heading ? kStartHeadingSigma : kPi / std::sqrt(3.0);
  estimate_.room_probability = start_.room ? 0.99 : largest / std::max(total, 1e-9);
  estimate_.state = TrackState::searching;
  summary_.count = 1;
  summary_.hypotheses[0] = {estimate_.room, estimate_.pose, estimate_.sigma_m, estimate_.room_probability};
}

void BayesLocator::Core::start_first_search() {
  SearchDomain domain;
  if (start_.room) domain.only_room = *start_.room;
  const std::uint64_t now = history_.end();
  const std::uint64_t window = search_.firings_to_tell(domain, belt_.sensors);
  if (now < window || echoes_since(now - window) < kFewestEchoes) return;
  hearing_test_ = HearingTest::due;
  // A start in a wall or outside its room is wrong, but most often not by much.
  if (start_.room && start_.position && is_finite(*start_.position)) {
    domain.near_room = *start_.room;
    domain.near_position = *start_.position;
  }
  if (start_.room && start_.heading) {
    domain.heading = *start_.heading;
  } else {
    domain.level_heading = compass_;
  }
  domain.heading_sigma = kStartHeadingSigma;
  model_ = seems_hard_of_hearing(domain.only_room) ? &deafened_ : &keen_;
  search_.start(domain, now - window, now);
}

}  // namespace echoway
