#include "walk_score.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "echoway/tracker/bayes_locator.hpp"

namespace echoway::eval {
namespace {

constexpr double kNowhere = 20.0;        // Metres: the error of an estimate without a room.
constexpr double kFoundFor = 3.0;        // Seconds.
constexpr double kFound = kMetresPerFoot;

double thread_microseconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

Start start_of(const Building& building, const TruthRow& row) {
  return {building.find_room(row.room), row.pose.position, row.pose.heading};
}

// An estimate beside the truth of its firing.
struct Deviation {
  double metres = kNowhere;
  double radians = kPi;
  bool right_room = false;
};

Deviation compare(const Building& building, const Estimate& estimate, const TruthRow& truth) {
  if (estimate.room == kNoRoom) return {};
  const RoomIndex room = building.find_room(truth.room);
  const Pose2 said = building.room(estimate.room).frame.compose(estimate.pose);
  const Pose2 is = building.room(room).frame.compose(truth.pose);
  return {distance(said.position, is.position), std::abs(wrap_angle(said.heading - is.heading)), estimate.room == room};
}

// Waits for the place to be right for a while.
class Finding {
 public:
  void note(double time_s, bool right) {
    if (!right) since_ = -1.0;
    if (right && since_ < 0.0) since_ = time_s;
    if (found_ < 0.0 && right && time_s - since_ > kFoundFor) found_ = since_;
  }
  [[nodiscard]] double after(double begin_s) const { return found_ < 0.0 ? -1.0 : found_ - begin_s; }

 private:
  double since_ = -1.0;
  double found_ = -1.0;
};

void add(WalkScore& sum, const Deviation& off, const Estimate& estimate) {
  ++sum.firings;
  sum.error_m += off.metres;
  sum.heading_error_deg += to_degrees(off.radians);
  sum.right_room += off.right_room;
  sum.within_2_sigma += off.metres <= 2.0 * estimate.sigma_m;
  sum.sigma_m += estimate.sigma_m;
}

void add_up_times(WalkScore& score, std::vector<double>& us) {
  const auto middle = us.begin() + static_cast<std::ptrdiff_t>(us.size() / 2);
  std::nth_element(us.begin(), middle, us.end());
  score.median_us = *middle;
  score.worst_us = *std::max_element(middle, us.end());
  for (const double t : us) score.mean_us += t;
}

}  // namespace

WalkScore score_walk(const Building& building, const sim::Simulation& walk, const Given& given) {
  BayesOptions options;
  options.seed = given.seed;
  if (given.particles > 0) options.particles = options.particles_without_gyroscope = given.particles;
  const Start start = given.start ? start_of(building, walk.truth.front()) : Start{};
  BayesLocator locator(building, walk.scans.belt.apply_to({}), start, options);

  WalkScore score;
  Finding finding;
  std::vector<double> us;
  std::size_t hint = 0;
  for (std::size_t i = 0; i < walk.scans.firings.size(); ++i) {
    const Firing& firing = walk.scans.firings[i];
    const double begin = thread_microseconds();
    while (given.hints && hint < walk.motion.size() && walk.motion[hint].time_s <= firing.time_s) locator.on_motion(walk.motion[hint++]);
    locator.on_firing(firing);
    us.push_back(thread_microseconds() - begin);
    const Deviation off = compare(building, locator.estimate(), walk.truth[i]);
    add(score, off, locator.estimate());
    finding.note(firing.time_s, off.right_room && off.metres < kFound);
  }
  if (score.firings == 0) return score;
  add_up_times(score, us);
  for (double* mean : {&score.error_m, &score.heading_error_deg, &score.right_room, &score.within_2_sigma, &score.sigma_m, &score.mean_us}) {
    *mean /= score.firings;
  }
  score.found_s = finding.after(walk.scans.firings.front().time_s);
  return score;
}

}  // namespace echoway::eval
