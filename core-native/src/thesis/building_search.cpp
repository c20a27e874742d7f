#include "thesis/building_search.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::thesis {
namespace {

// Scans that a place must have explained before it can stand out.
constexpr int kLeastScans = 2;
// A place is given up when it is this many margins behind the first, or its mean objective is above this share of what
// a reading can differ at most.
constexpr double kGiveUp = 4.0;
constexpr double kHopeless = 0.8;

}  // namespace

BuildingSearch::BuildingSearch(const Start& start, const BeltConfig& belt, const ThesisParameters& parameters)
    : start_(start), belt_(belt), parameters_(parameters) {
  const auto capacity = static_cast<std::size_t>(std::max(2, parameters.hypotheses));
  modes_.reserve(capacity);
  places_.reserve(capacity);
}

void BuildingSearch::add(const Scan& scan, double growth, std::span<const PoseMatcher> rooms,
                         MatchWorkspace& workspace) {
  if (!places_.empty()) follow(scan, growth, rooms, workspace);
  if (places_.empty()) begin(scan, rooms, workspace);
}

bool BuildingSearch::decided() const noexcept {
  if (places_.empty() || places_.front().scans < kLeastScans) return false;
  return places_.size() == 1 || (places_[1].mode.objective_m - places_[0].mode.objective_m) * places_[0].scans >=
                                    parameters_.unique_margin_m;
}

double BuildingSearch::spacing_for(std::span<const PoseMatcher> rooms, const Bounds& bounds) const noexcept {
  const double headings = belt_.sensors * sensor_step(belt_.sensors, parameters_.search_heading_spacing_rad) *
                          std::min(1.0, bounds.half_turn / kPi);
  double area = 0.0;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (start_.room && *start_.room != static_cast<RoomIndex>(i)) continue;
    const Vec2 size = rooms[i].floor().high() - rooms[i].floor().low();
    area += std::min(size.x, 2.0 * bounds.radius) * std::min(size.y, 2.0 * bounds.radius);
  }
  return std::max(parameters_.search_spacing_m, std::sqrt(area * headings / parameters_.search_candidates));
}

void BuildingSearch::begin(const Scan& scan, std::span<const PoseMatcher> rooms, MatchWorkspace& workspace) {
  Bounds bounds;
  if (start_.position) {
    bounds.centre = *start_.position;
    bounds.radius = parameters_.movement_m;
  }
  if (start_.heading) {
    bounds.heading = *start_.heading;
    bounds.half_turn = parameters_.rotation_rad;
  }
  const Grid grid{spacing_for(rooms, bounds), sensor_step(belt_.sensors, parameters_.search_heading_spacing_rad)};
  modes_.clear();
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const auto room = static_cast<RoomIndex>(i);
    if (start_.room && *start_.room != room) continue;
    rooms[i].search(scan, bounds, grid, room, modes_, workspace);
  }
  for (Mode& mode : modes_) {
    const PoseMatcher& room = rooms[static_cast<std::size_t>(mode.room)];
    Bounds about = bounds;
    if (!start_.heading) about.heading = mode.pose.heading;
    room.refine(scan, about, grid, mode, workspace);
    mode.pose.heading = wrap_angle(mode.pose.heading);
  }
  std::stable_sort(modes_.begin(), modes_.end(),
                   [](const Mode& a, const Mode& b) { return a.objective_m < b.objective_m; });
  for (const Mode& mode : modes_) places_.push_back({mode, 1});
}

void BuildingSearch::follow(const Scan& scan, double growth, std::span<const PoseMatcher> rooms,
                            MatchWorkspace& workspace) {
  modes_.clear();
  for (Place& place : places_) {
    Bounds bounds;
    bounds.centre = place.mode.pose.position;
    bounds.radius = growth * parameters_.movement_m;
    bounds.heading = place.mode.pose.heading;
    bounds.half_turn = std::min(kPi, growth * parameters_.rotation_rad);
    const auto& room = rooms[static_cast<std::size_t>(place.mode.room)];
    const Match match = room.match(scan, bounds, workspace);
    const double objective = match.found ? match.objective_m : parameters_.mismatch_m;
    if (match.found) place.mode.pose = match.pose;
    ++place.scans;
    place.mode.objective_m += (objective - place.mode.objective_m) / place.scans;
    offer_mode(place.mode, modes_);  // two that have met are one
  }
  const int scans = places_.front().scans;
  places_.clear();
  for (const Mode& mode : modes_) {
    const double behind = (mode.objective_m - modes_.front().objective_m) * scans;
    if (mode.objective_m < kHopeless * parameters_.mismatch_m && behind < kGiveUp * parameters_.unique_margin_m) {
      places_.push_back({mode, scans});
    }
  }
}

}  // namespace echoway::thesis
