#include "echoway/thesis/thesis_locator.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "echoway/locate/start_check.hpp"
#include "thesis/building_search.hpp"
#include "thesis/candidate_queue.hpp"
#include "thesis/exits.hpp"
#include "thesis/pose_matcher.hpp"
#include "thesis/position_belief.hpp"
#include "thesis/scan.hpp"

namespace echoway {
namespace thesis {
namespace {

constexpr double kColdest = -60.0;  // degrees Celsius; a thermometer beyond these is broken
constexpr double kHottest = 90.0;
constexpr double kLeastSigma = 0.01;

class ThesisLocator final : public Locator {
 public:
  ThesisLocator(const Building& building, const BeltConfig& belt, const Start& start,
                const ThesisParameters& parameters);

  bool on_firing(const Firing& firing) override;
  void on_motion(const MotionHint&) override {}
  void on_temperature(double celsius) override;
  [[nodiscard]] const Estimate& estimate() const override { return estimate_; }
  [[nodiscard]] std::span<const Hypothesis> hypotheses() const override { return hypotheses_; }
  [[nodiscard]] std::span<const SensorSuspicion> suspicions() const override { return {}; }

 private:
  [[nodiscard]] bool usable(const Firing& firing) noexcept;
  [[nodiscard]] double growth(const Scan& scan) const noexcept;
  [[nodiscard]] const PoseMatcher& matcher(RoomIndex room) const { return rooms_[static_cast<std::size_t>(room)]; }

  [[nodiscard]] bool is_good(const Match& match) const noexcept {
    return match.found && match.objective_m <= parameters_.poor_match_m;
  }

  void search(const Scan& scan);
  void track(const Scan& scan);
  Match match_current(const Scan& scan, Bounds bounds);
  void match_candidates(const Scan& scan, double wider);
  void drop_left_behind();
  void enter(const Candidate& candidate);
  [[nodiscard]] const Exit* nearest_exit(RoomIndex to) const noexcept;
  void accept(const Scan& scan, const Match& match);
  void report_speed(const Scan& scan, const Match& match) noexcept;
  void report_uncertainty(const Match& match);
  void report_rooms();

  BeltConfig belt_;
  ThesisParameters parameters_;
  std::vector<PoseMatcher> rooms_;
  std::vector<std::vector<Exit>> exits_;
  MatchWorkspace workspace_;
  ScanAssembler assembler_;
  CandidateQueue queue_;
  std::optional<BuildingSearch> search_;
  PositionBelief belief_;
  Estimate estimate_;
  std::vector<Hypothesis> hypotheses_;
  double range_scale_ = 1.0;
  double newest_firing_s_ = -1e300;
  int backwards_ = 0;              ///< Firings in a row that were older than the newest.
  std::optional<double> good_s_;   ///< Time of the last good match; of the first scan until there is one.
  int bad_scans_ = 0;              ///< In a row.
};

ThesisLocator::ThesisLocator(const Building& building, const BeltConfig& belt, const Start& start,
                             const ThesisParameters& parameters)
    : belt_(belt),
      parameters_(parameters),
      exits_(exits_of(building)),
      workspace_(belt, parameters),
      assembler_(belt, parameters),
      queue_(parameters, building.rooms.size()) {
  const DetectionTable detection(belt, parameters.detection);
  rooms_.reserve(building.rooms.size());
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    rooms_.emplace_back(building.rooms[i], openings_of(building, static_cast<RoomIndex>(i)), belt, detection,
                        parameters);
  }
  hypotheses_.reserve(
      std::max(building.rooms.size() + 1, static_cast<std::size_t>(std::max(2, parameters.hypotheses))));
  if (!(start.room && start.position && start.heading)) {
    search_.emplace(start, belt, parameters);
    return;
  }
  estimate_.room = *start.room;
  estimate_.pose = {*start.position, wrap_angle(*start.heading)};
  estimate_.state = TrackState::tracking;
  belief_.reset(0.5 * parameters.movement_m);
  report_uncertainty({});
  report_rooms();
}

void ThesisLocator::on_temperature(double celsius) {
  if (!(celsius > kColdest && celsius < kHottest)) return;
  const bool plausible = belt_.temperature_c > kColdest && belt_.temperature_c < kHottest;
  range_scale_ = speed_of_sound(celsius) / speed_of_sound(plausible ? belt_.temperature_c : kReferenceCelsius);
}

// A firing older than the newest is dropped, but a whole pass of them means that the clock was set back.
bool ThesisLocator::usable(const Firing& firing) noexcept {
  if (firing.sensor < 0 || firing.sensor >= belt_.sensors) return false;
  if (!std::isfinite(firing.time_s) || !std::isfinite(firing.range_m)) return false;
  if (firing.time_s < newest_firing_s_ && ++backwards_ <= belt_.sensors) return false;
  if (firing.time_s < newest_firing_s_) {
    assembler_.restart();
    good_s_.reset();
  }
  backwards_ = 0;
  newest_firing_s_ = firing.time_s;
  return true;
}

bool ThesisLocator::on_firing(const Firing& firing) {
  if (!usable(firing)) return false;
  Firing scaled = firing;
  if (firing.has_echo()) scaled.range_m *= range_scale_;
  if (!assembler_.add(scaled)) return false;
  const Scan& scan = assembler_.scan();
  if (search_) {
    search(scan);
  } else {
    track(scan);
  }
  estimate_.sound_speed_scale = range_scale_;
  if (estimate_.room == kNoRoom) return false;
  estimate_.time_s = scan.time_s;
  return true;
}

// The thesis's bounds hold for one scan's time; the longer the last good match is ago, the farther the wearer may be
// from where it put them.
double ThesisLocator::growth(const Scan& scan) const noexcept {
  const double usual = parameters_.passes * belt_.sensors * belt_.slot_s;
  if (!good_s_ || !(usual > 0.0)) return 1.0;
  return std::clamp((scan.time_s - *good_s_) / usual, 1.0, parameters_.widest_growth);
}

void ThesisLocator::search(const Scan& scan) {
  search_->add(scan, growth(scan), rooms_, workspace_);
  good_s_ = scan.time_s;
  const auto& places = search_->places();
  hypotheses_.clear();
  if (places.empty()) {
    estimate_.state = TrackState::searching;
    return;
  }
  // Soft shares by how much worse each matches than the best.
  double total = 0.0;
  const double best = places.front().mode.objective_m;
  const double scale = std::max(parameters_.map_error_m, 0.25 * best);
  const auto share = [&](const Place& p) { return std::exp((best - p.mode.objective_m) / scale); };
  for (const Place& place : places) total += share(place);
  double in_room = 0.0;
  Match others;  // the spread of the places in the same room
  for (const Place& place : places) {
    const double probability = share(place) / total;
    hypotheses_.push_back({place.mode.room, place.mode.pose, parameters_.movement_m, probability});
    if (place.mode.room != places.front().mode.room) continue;
    in_room += probability;
    const Vec2 apart = place.mode.pose.position - places.front().mode.pose.position;
    others.spread_xx += probability * apart.x * apart.x;
    others.spread_xy += probability * apart.x * apart.y;
    others.spread_yy += probability * apart.y * apart.y;
  }
  estimate_.room = places.front().mode.room;
  estimate_.pose = places.front().mode.pose;
  estimate_.room_probability = std::min(1.0, in_room);
  estimate_.speed_mps = 0.0;
  estimate_.state = TrackState::searching;
  belief_.reset(parameters_.movement_m);
  report_uncertainty(others);
  if (!search_->decided()) return;
  search_.reset();
  estimate_.state = TrackState::tracking;
  belief_.reset(0.5 * parameters_.movement_m);
  bad_scans_ = 0;
  report_rooms();
}

void ThesisLocator::track(const Scan& scan) {
  const Pose2 before = estimate_.pose;
  const double wider = growth(scan);
  if (!good_s_) good_s_ = scan.time_s - parameters_.passes * belt_.sensors * belt_.slot_s;
  const Bounds bounds{before.position, wider * parameters_.movement_m, before.heading,
                      std::min(kPi, wider * parameters_.rotation_rad)};
  const Match match = match_current(scan, bounds);
  belief_.move(0.5 * bounds.radius);
  const Pose2 now = match.found ? match.pose : before;
  for (const Exit& exit : exits_[static_cast<std::size_t>(estimate_.room)]) {
    if (distance(exit.at, now.position) <= parameters_.exit_reach_m) queue_.add(exit.to);
  }
  match_candidates(scan, wider);
  queue_.update(match);
  if (const Candidate* candidate = queue_.entered()) {
    const Candidate entered = *candidate;
    enter(entered);
    accept(scan, entered.match);
  } else {
    queue_.purge();
    report_speed(scan, match);
    accept(scan, match);
    drop_left_behind();
  }
  report_rooms();
}

// Where nothing within the bounds matches well, the wearer may have turned on the spot, faster than the thesis's +-20
// degrees allow.
Match ThesisLocator::match_current(const Scan& scan, Bounds bounds) {
  const PoseMatcher& room = matcher(estimate_.room);
  const Match match = room.match(scan, bounds, workspace_);
  if (is_good(match)) return match;
  bounds.half_turn = kPi;
  const Match turned = room.match(scan, bounds, workspace_);
  return is_good(turned) ? turned : match;
}

// Each candidate room is matched about where the wearer was, seen from its frame through the exit that leads there.
void ThesisLocator::match_candidates(const Scan& scan, double wider) {
  const double factor = std::min(wider * parameters_.candidate_growth, parameters_.widest_growth);
  for (Candidate& candidate : queue_.candidates()) {
    const Exit* exit = nearest_exit(candidate.room);
    if (exit == nullptr) continue;
    const Pose2 there = exit->into.compose(estimate_.pose);
    const Bounds bounds{there.position, factor * parameters_.movement_m, there.heading,
                        std::min(kPi, factor * parameters_.rotation_rad)};
    candidate.match = matcher(candidate.room).match(scan, bounds, workspace_);
  }
}

const Exit* ThesisLocator::nearest_exit(RoomIndex to) const noexcept {
  const Exit* nearest = nullptr;
  const Vec2 here = estimate_.pose.position;
  for (const Exit& exit : exits_[static_cast<std::size_t>(estimate_.room)]) {
    if (exit.to == to && (!nearest || distance(exit.at, here) < distance(nearest->at, here))) nearest = &exit;
  }
  return nearest;
}

// (5.2) alone hardly ever takes a candidate below 10 %: its fixed point is the share of the two matches. One whose exit
// is out of a scan's reach is out of the question.
void ThesisLocator::drop_left_behind() {
  const double reach = parameters_.exit_reach_m + parameters_.movement_m;
  std::erase_if(queue_.candidates(), [&](const Candidate& c) {
    const Exit* exit = nearest_exit(c.room);
    return exit == nullptr || distance(exit->at, estimate_.pose.position) > reach;
  });
}

void ThesisLocator::enter(const Candidate& candidate) {
  const Exit* exit = nearest_exit(candidate.room);
  if (exit != nullptr) belief_.rotate(exit->into.heading);
  estimate_.room = candidate.room;
  estimate_.speed_mps = 0.0;
  queue_.flush();
}

void ThesisLocator::accept(const Scan& scan, const Match& match) {
  if (match.found) {
    estimate_.pose = match.pose;
    belief_.observe(scan, match, matcher(estimate_.room).model(), parameters_);
  }
  const bool good = is_good(match);
  bad_scans_ = good ? 0 : bad_scans_ + 1;
  if (good) good_s_ = scan.time_s;
  if (good) estimate_.state = TrackState::tracking;
  if (bad_scans_ >= parameters_.lost_after) estimate_.state = TrackState::lost;
  report_uncertainty(match);
}

// Between two good matches in one room; elsewhere there is nothing to tell a speed from.
void ThesisLocator::report_speed(const Scan& scan, const Match& match) noexcept {
  const double elapsed = scan.time_s - *good_s_;
  const bool tells = match.found && bad_scans_ == 0 && elapsed > 0.0;
  const Vec2 moved = match.pose.position - estimate_.pose.position;
  estimate_.speed_mps = tells ? dot(moved, unit_from_angle(match.pose.heading)) / elapsed : 0.0;
}

void ThesisLocator::report_uncertainty(const Match& match) {
  const Symmetric2 covariance =
      belief_.covariance() + Symmetric2{match.spread_xx, match.spread_xy, match.spread_yy};
  estimate_.covariance_xx = covariance.xx;
  estimate_.covariance_xy = covariance.xy;
  estimate_.covariance_yy = covariance.yy;
  estimate_.sigma_m = std::max(kLeastSigma, std::sqrt(covariance.greatest_eigenvalue()));
  const double step = kTwoPi / belt_.sensors / sensor_step(belt_.sensors, parameters_.heading_spacing_rad);
  estimate_.sigma_heading_rad =
      match.found ? std::sqrt(match.spread_heading + step * step / 12.0) : parameters_.rotation_rad;
}

// The thesis gives candidates likelihoods of their own; the current room keeps what they leave.
void ThesisLocator::report_rooms() {
  double stay = 1.0;
  double total = 0.0;
  for (const Candidate& c : queue_.candidates()) {
    stay *= 1.0 - c.likelihood;
    total += c.likelihood;
  }
  total += stay;
  hypotheses_.clear();
  estimate_.room_probability = total > 0.0 ? stay / total : 1.0;
  hypotheses_.push_back({estimate_.room, estimate_.pose, estimate_.sigma_m, estimate_.room_probability});
  for (const Candidate& c : queue_.candidates()) {
    if (!c.match.found) continue;
    hypotheses_.push_back(
        {c.room, c.match.pose, parameters_.candidate_growth * estimate_.sigma_m, c.likelihood / total});
  }
  std::stable_sort(hypotheses_.begin(), hypotheses_.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.probability > b.probability; });
}

}  // namespace
}  // namespace thesis

Result<std::unique_ptr<Locator>> make_thesis_locator(const Building& building, const BeltConfig& belt,
                                                     const Start& start, const ThesisParameters& parameters) {
  if (belt.sensors < 1 || belt.sensors > kMaxSensors) {
    return Error{"the belt has " + std::to_string(belt.sensors) + " sensors; it must have 1 to " +
                 std::to_string(kMaxSensors)};
  }
  const double numbers[] = {belt.radius_m,    belt.beam_rad,    belt.slot_s,       belt.min_range_m,
                            belt.max_range_m, belt.range_noise, belt.temperature_c};
  if (!std::all_of(std::begin(numbers), std::end(numbers), [](double x) { return std::isfinite(x); })) {
    return Error{"the belt's description holds a number that is not finite"};
  }
  if (belt.radius_m < 0.0) return Error{"the belt's radius is negative"};
  if (!(belt.max_range_m > 0.0)) return Error{"the belt's maximum range is not positive"};
  if (building.rooms.empty()) return Error{"the building has no rooms"};
  if (Status good = check_start(start, building); !good) return good.error();
  return std::unique_ptr<Locator>(new thesis::ThesisLocator(building, belt, start, parameters));
}

}  // namespace echoway
