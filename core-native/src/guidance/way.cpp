#include "guidance/way.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoway::guidance {
namespace {

bool leaves_room(const Waypoint& w) { return w.kind == WaypointKind::door || w.kind == WaypointKind::link_from; }

bool is_suffix(const std::vector<std::int32_t>& tail, const std::vector<std::int32_t>& whole) {
  return tail.size() <= whole.size() && std::equal(tail.rbegin(), tail.rend(), whole.rbegin());
}

}  // namespace

void Way::lead_to(RouteTree tree) {
  clear();
  tree_ = std::move(tree);
  mode_ = Mode::tree;
}

void Way::lead_back(std::vector<Spot> crumbs) {
  clear();
  crumbs_ = std::move(crumbs);
  mode_ = Mode::crumbs;
}

void Way::clear() {
  mode_ = Mode::none;
  route_.clear();
  line_.clear();
  doors_.clear();
  changed_ = new_ = false;
  least_cost_ = 1e300;
  hindrances_.clear();
}

void Way::start_over() {
  if (mode_ == Mode::tree) lead_to(std::move(tree_));
  else clear();
}

Status Way::check(RoomIndex room, std::optional<Vec2> at) const {
  return mode_ == Mode::tree ? router_->check_way(room, at, tree_) : success();
}

/// The door or stairs of the way so far, while the wearer is in the same room.
BoundFor Way::bound_for(const Estimate& e) const {
  for (const Waypoint& w : route_.waypoints) {
    if (!leaves_room(w)) continue;
    if (w.room != e.room) break;
    return {w.kind, w.index, config_->other_way_m + 2.0 * std::min(e.sigma_m, 1.0)};
  }
  return {};
}

bool Way::route_from(const Estimate& e, const BoundFor& bound, Route& route) const {
  const Spot here{e.room, e.pose.position};
  if (mode_ == Mode::tree) return static_cast<bool>(router_->route_from(here, tree_, route, bound));
  Result<Route> back = router_->retrace(here, crumbs_);
  if (!back) return false;
  route = std::move(*back);
  return true;
}

std::optional<double> Way::heading_from(const Estimate& e) {
  constexpr double kAhead = 1.0;  // metres
  if (mode_ == Mode::none || !route_from(e, {}, guess_)) return std::nullopt;
  lay_out(guess_, router_->building(), guess_line_);
  const Vec2 to = point_along(guess_line_, kAhead) - e.pose.position;
  return std::atan2(to.y, to.x);
}

bool Way::find(const Estimate& e) {
  changed_ = false;
  if (!route_from(e, bound_for(e), route_)) return false;
  lay_out(route_, router_->building(), line_);
  hindrances_.bend(router_->space(e.room), e.room, e.time_s, line_);
  compare_doors();
  return true;
}

void Way::compare_doors() {
  new_doors_.clear();
  for (const Waypoint& w : route_.waypoints) {
    if (leaves_room(w)) new_doors_.push_back(w.index);
  }
  // Doors passed drop off the front; a door just passed comes back for a moment when the room is in doubt.
  const bool one_more = new_doors_.size() == doors_.size() + 1;
  const bool same = is_suffix(new_doors_, doors_) || (one_more && is_suffix(doors_, new_doors_));
  changed_ = !same && !doors_.empty();
  if (changed_) {
    new_ = true;
    forget_progress();
  }
  if (!same || is_suffix(new_doors_, doors_)) doors_ = new_doors_;
}

Way::DoorAhead Way::first_door() const noexcept {
  double along = 0.0;
  for (std::size_t i = 0; i < line_.size(); ++i) {
    if (i > 0) along += distance(line_[i - 1].at, line_[i].at);
    if (line_[i].kind == WaypointKind::door) return {&line_[i], along};
  }
  return {};
}

bool Way::leads_through(std::int32_t door) const noexcept {
  return std::find(new_doors_.begin(), new_doors_.end(), door) != new_doors_.end();
}

void Way::note_progress() noexcept { least_cost_ = std::min(least_cost_, route_.cost); }

bool Way::is_astray(double sigma_m) const noexcept {
  return route_.cost > least_cost_ + config_->wrong_way_m + 2.0 * sigma_m;
}

}  // namespace echoway::guidance
