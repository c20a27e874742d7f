#include "thesis/pose_matcher.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/vec2.hpp"

namespace echoway::thesis {
namespace {

// An objective has to be less by this much to be better: equal matches are decided by the order of the grid, nearest to
// the centre first, and not by rounding.
constexpr double kTie = 1e-9;                      // metres
constexpr double kAlikeDistance = 1.0;             // metres; nearer modes are one
constexpr double kAlikeTurn = degrees(30.0);
constexpr int kMostMoves = 4;                      // on one level of refinement
constexpr double kPlateau = 1e-3;                  // metres; headings that match this much worse match as well
constexpr double kNegligible = 12.0;               // exp(-12)

struct Headings {
  int count;   // of a full turn
  int reach;   // to either side
  double step;

  [[nodiscard]] bool full() const noexcept { return 2 * reach + 1 >= count; }
};

Headings headings_for(int sensors, int sensor_step, double half_turn) noexcept {
  const int count = sensors * sensor_step;
  const double step = kTwoPi / count;
  const int reach = half_turn >= kPi ? count / 2 : static_cast<int>(std::floor(half_turn / step + kTie));
  return {count, std::min(reach, count / 2), step};
}

// Calls visit(heading offset, direction index) for 0, 1, -1, 2, -2, ...; each direction once.
template <class Visit>
void for_headings(const Headings& h, Visit visit) {
  visit(0, 0);
  for (int i = 1; i <= h.reach; ++i) {
    visit(i, i);
    if (2 * i != h.count) visit(-i, h.count - i);
  }
}

// Poses that match about as well as the best, weighted by how well: a soft minimum's spread, in one pass.
class Spread {
 public:
  Spread(Vec2 centre, double scale) : centre_(centre), scale_(scale) {}

  void add(Vec2 position, double turn, double objective) noexcept {
    const double lead = (best_ - objective) / scale_;
    if (lead < -kNegligible) return;
    double weight = 1.0;
    if (lead > 0.0) {
      const double fade = std::exp(-lead);
      for (double* sum : {&sum_, &x_, &y_, &xx_, &xy_, &yy_, &h_, &hh_}) *sum *= fade;
      best_ = objective;
    } else {
      weight = std::exp(lead);
    }
    const Vec2 d = position - centre_;
    sum_ += weight;
    x_ += weight * d.x;
    y_ += weight * d.y;
    xx_ += weight * d.x * d.x;
    xy_ += weight * d.x * d.y;
    yy_ += weight * d.y * d.y;
    h_ += weight * turn;
    hh_ += weight * turn * turn;
  }

  void report(Match& match) const noexcept {
    if (!(sum_ > 0.0)) return;
    const double x = x_ / sum_;
    const double y = y_ / sum_;
    const double h = h_ / sum_;
    match.spread_xx = std::max(0.0, xx_ / sum_ - x * x);
    match.spread_yy = std::max(0.0, yy_ / sum_ - y * y);
    match.spread_xy = xy_ / sum_ - x * y;
    match.spread_heading = std::max(0.0, hh_ / sum_ - h * h);
  }

 private:
  Vec2 centre_;
  double scale_;
  double best_ = 1e300;
  double sum_ = 0.0;
  double x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0, h_ = 0.0, hh_ = 0.0;
};

double displacement_cost(const Bounds& bounds, Vec2 position, const ThesisParameters& parameters) noexcept {
  if (bounds.whole_room() || !(bounds.radius > 0.0)) return 0.0;
  return parameters.displacement_m * squared_norm(position - bounds.centre) / (bounds.radius * bounds.radius);
}

bool alike(const Mode& a, const Mode& b) noexcept {
  return a.room == b.room && distance(a.pose.position, b.pose.position) < kAlikeDistance &&
         std::abs(wrap_angle(a.pose.heading - b.pose.heading)) < kAlikeTurn;
}

}  // namespace

int sensor_step(int sensors, double spacing) noexcept {
  return std::max(1, static_cast<int>(std::lround(kTwoPi / sensors / spacing)));
}

void offer_mode(const Mode& mode, std::vector<Mode>& modes) {
  const std::size_t capacity = modes.capacity();
  if (modes.size() == capacity && !(mode.objective_m < modes.back().objective_m)) return;
  for (const Mode& other : modes) {
    if (other.objective_m <= mode.objective_m + kTie && alike(other, mode)) return;
  }
  std::erase_if(modes, [&](const Mode& other) { return alike(other, mode); });
  if (modes.size() == capacity) modes.pop_back();
  const auto place = std::upper_bound(modes.begin(), modes.end(), mode, [](const Mode& a, const Mode& b) {
    return a.objective_m < b.objective_m;
  });
  modes.insert(place, mode);
}

MatchWorkspace::MatchWorkspace(const BeltConfig& belt, const ThesisParameters& parameters) : echoes_(parameters) {
  const double widest = parameters.movement_m * parameters.widest_growth;
  const int reach = static_cast<int>(widest / parameters.position_spacing_m);
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      const double d = hypotenuse(i, j);
      if (d <= reach) offsets_.push_back({static_cast<double>(i), static_cast<double>(j), d});
    }
  }
  std::stable_sort(offsets_.begin(), offsets_.end(),
                   [](const Offset& a, const Offset& b) { return a.distance < b.distance; });
  const double finest = std::min(parameters.heading_spacing_rad, parameters.search_heading_spacing_rad);
  const int most = belt.sensors * sensor_step(belt.sensors, finest);
  directions_.reset(0.0, most);
  echoes_.reserve(most);
}

PoseMatcher::PoseMatcher(const Room& room, const std::vector<Opening>& openings, const BeltConfig& belt,
                         const DetectionTable& detection, const ThesisParameters& parameters)
    : parameters_(parameters),
      least_matches_(std::min(parameters.least_matches, belt.sensors)),
      floor_(room),
      model_(room, openings, belt, detection, parameters.model) {}

Match PoseMatcher::match(const Scan& scan, const Bounds& bounds, MatchWorkspace& workspace) const {
  const Grid grid{parameters_.position_spacing_m, sensor_step(model_.belt().sensors, parameters_.heading_spacing_rad)};
  const Headings headings = headings_for(model_.belt().sensors, grid.sensor_step, bounds.half_turn);
  Spread spread(bounds.centre, parameters_.map_error_m / std::max(1, least_matches_));
  // The grid turns with the wearer, so the answer turns with the map.
  const Pose2 layout{bounds.centre, bounds.heading};
  Match match;
  Mode best;
  workspace.directions_.reset(bounds.heading, headings.count);
  for (const auto& offset : workspace.offsets_) {
    if (offset.distance * grid.spacing > bounds.radius + kTie) break;
    const Vec2 position = layout.transform(grid.spacing * Vec2{offset.x, offset.y});
    if (!floor_.contains(position)) continue;
    workspace.echoes_.simulate(model_, position, workspace.directions_);
    const double cost = displacement_cost(bounds, position, parameters_);
    for_headings(headings, [&](int turn, int direction) {
      ++match.candidates;
      const Score score = workspace.echoes_.score(scan, direction, grid.sensor_step);
      if (score.matched < least_matches_) return;
      const double objective = score.objective_m + cost;
      spread.add(position, turn * headings.step, objective);
      if (objective < best.objective_m - kTie) best = {0, {position, bounds.heading + turn * headings.step}, objective};
    });
  }
  if (best.room == kNoRoom) return match;
  refine(scan, bounds, grid, best, workspace);
  match.found = true;
  match.pose = {best.pose.position, wrap_angle(best.pose.heading)};
  match.objective_m = std::max(0.0, best.objective_m - displacement_cost(bounds, best.pose.position, parameters_));
  match.quality = match.objective_m / std::max(model_.greatest_range(), parameters_.map_error_m);
  spread.report(match);
  return match;
}

void PoseMatcher::search(const Scan& scan, const Bounds& bounds, const Grid& grid, RoomIndex room,
                         std::vector<Mode>& modes, MatchWorkspace& workspace) const {
  const Headings headings = headings_for(model_.belt().sensors, grid.sensor_step, bounds.half_turn);
  const Vec2 reach{bounds.radius, bounds.radius};
  const Vec2 margin{0.5 * grid.spacing, 0.5 * grid.spacing};
  const Pose2 layout = bounds.whole_room() ? floor_.frame() : Pose2{bounds.centre, bounds.heading};
  const Vec2 low = bounds.whole_room() ? floor_.low() + margin : -reach;
  const Vec2 high = bounds.whole_room() ? floor_.high() : reach;
  const double heading = headings.full() ? layout.heading : bounds.heading;
  workspace.directions_.reset(heading, headings.count);
  for (int i = 0; low.x + i * grid.spacing <= high.x; ++i) {
    for (int j = 0; low.y + j * grid.spacing <= high.y; ++j) {
      const Vec2 local = low + grid.spacing * Vec2{static_cast<double>(i), static_cast<double>(j)};
      const Vec2 position = layout.transform(local);
      if ((!bounds.whole_room() && norm(local) > bounds.radius) || !floor_.contains(position)) continue;
      workspace.echoes_.simulate(model_, position, workspace.directions_);
      for_headings(headings, [&](int turn, int direction) {
        const Score score = workspace.echoes_.score(scan, direction, grid.sensor_step);
        if (score.matched < least_matches_) return;
        offer_mode({room, {position, heading + turn * headings.step}, score.objective_m}, modes);
      });
    }
  }
}

bool PoseMatcher::score_pose(const Scan& scan, const Bounds& bounds, const Pose2& pose, double& objective,
                             MatchWorkspace& workspace) const {
  if (distance(pose.position, bounds.centre) > bounds.radius + kTie || !floor_.contains(pose.position)) return false;
  if (std::abs(pose.heading - bounds.heading) > bounds.half_turn + kTie) return false;
  workspace.directions_.reset(pose.heading, model_.belt().sensors);
  workspace.echoes_.simulate(model_, pose.position, workspace.directions_);
  const Score score = workspace.echoes_.score(scan, 0, 1);
  objective = score.objective_m + displacement_cost(bounds, pose.position, parameters_);
  return score.matched >= least_matches_;
}

void PoseMatcher::try_pose(const Scan& scan, const Bounds& bounds, const Pose2& pose, Mode& mode,
                           MatchWorkspace& workspace) const {
  double objective = 0.0;
  if (score_pose(scan, bounds, pose, objective, workspace) && objective < mode.objective_m - kTie) {
    mode = {mode.room, pose, objective};
  }
}

void PoseMatcher::refine(const Scan& scan, const Bounds& bounds, const Grid& grid, Mode& mode,
                         MatchWorkspace& workspace) const {
  double spacing = grid.spacing;
  double turn = kTwoPi / model_.belt().sensors / grid.sensor_step;
  for (int level = 0; level < parameters_.refinements; ++level) {
    spacing *= 0.5;
    turn *= 0.5;
    for (int move = 0; move < kMostMoves; ++move) {
      const Mode from = mode;
      for (const Vec2 step : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}, Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1},
                              Vec2{-1, -1}}) {
        const Vec2 position = Pose2{from.pose.position, bounds.heading}.transform(spacing * step);
        try_pose(scan, bounds, {position, from.pose.heading}, mode, workspace);
      }
      for (const double sign : {1.0, -1.0}) {
        try_pose(scan, bounds, {mode.pose.position, from.pose.heading + sign * turn}, mode, workspace);
      }
      if (!(mode.objective_m < from.objective_m - kTie)) break;
    }
  }
  centre_heading(scan, bounds, turn, mode, workspace);
}

// A heading changes nothing until a reading passes from one sensor to the next, so the best match is a plateau of
// headings; its middle is the one that errs least.
void PoseMatcher::centre_heading(const Scan& scan, const Bounds& bounds, double step, Mode& mode,
                                 MatchWorkspace& workspace) const {
  const double widest = kTwoPi / model_.belt().sensors;
  const auto edge = [&](double sign) {
    double reach = 0.0;
    double objective = 0.0;
    while (reach + step <= widest &&
           score_pose(scan, bounds, {mode.pose.position, mode.pose.heading + sign * (reach + step)}, objective,
                      workspace) &&
           objective <= mode.objective_m + kPlateau) {
      reach += step;
    }
    return reach;
  };
  mode.pose.heading += 0.5 * (edge(1.0) - edge(-1.0));
}

}  // namespace echoway::thesis
