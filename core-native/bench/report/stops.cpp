#include "stops.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "echoway/geometry/inclusion.hpp"
#include "echoway/sim/walk_file.hpp"

namespace echoway::report {
namespace {

constexpr double kPasses = 2.0;
constexpr double kTurnStep = degrees(20.0);
constexpr double kStill = 0.002;             // Metres,
constexpr double kStillTurn = degrees(0.2);  // and radians: who moves less than this is standing.

bool still(const TruthRow& a, const TruthRow& b) {
  return a.room == b.room && distance(a.pose.position, b.pose.position) < kStill &&
         std::abs(wrap_angle(a.pose.heading - b.pose.heading)) < kStillTurn;
}

Pose2 on_level(const Building& world, const TruthRow& row) {
  return world.room(world.find_room(row.room)).frame.compose(row.pose);
}

// Nobody stands in a doorway or with the belt against a wall.
bool can_stand(const Building& world, const TruthRow& row) {
  constexpr double kClear = 0.3;  // Metres.
  const Room& room = world.room(world.find_room(row.room));
  const auto clear = [&](const Segment& s) { return distance(s, row.pose.position) >= kClear; };
  return contains(room.boundary, row.pose.position) && std::all_of(room.walls.begin(), room.walls.end(), clear) &&
         std::all_of(room.reflectors.begin(), room.reflectors.end(), clear);
}

// Where a steady wearer who walks one leg is after every step of it.
void add_leg(const Building& world, const sim::Simulation& leg, double step_m, double pause_s, sim::Walk& walk) {
  Pose2 last = on_level(world, leg.truth.front());
  for (std::size_t i = 1; i < leg.truth.size(); ++i) {
    const TruthRow& row = leg.truth[i];
    const Pose2 here = on_level(world, row);
    const bool moved = distance(here.position, last.position) >= step_m;
    const bool turned = std::abs(wrap_angle(here.heading - last.heading)) >= kTurnStep;
    const bool on_the_spot = distance(here.position, on_level(world, leg.truth[i - 1]).position) < kStill;
    if (!moved && !(turned && on_the_spot) && i + 1 < leg.truth.size()) continue;
    if (!can_stand(world, row)) continue;
    walk.add(sim::GoTo{{row.room, row.pose.position}});
    walk.add(sim::Face{row.pose.heading});
    walk.add(sim::Pause{pause_s});
    last = here;
  }
}

}  // namespace

double pause_for(const BeltConfig& belt) noexcept {
  constexpr double kSettling = 1.2;  // Until the last stride's sway has died down.
  return kPasses * belt.sensors * belt.slot_s + kSettling;
}

sim::Simulation walk_through(const Building& world, const sim::Walk& walk) {
  auto run = sim::simulate(world, walk);
  if (!run) throw std::runtime_error(run.error().to_string());
  return std::move(*run);
}

sim::Walk read_plan_walk(std::string_view plan, std::string_view name) {
  const auto file = std::filesystem::path(ECHOWAY_MAPS_DIR) / plan / "walks" / (std::string(name) + ".walk");
  auto walk = sim::read_walk(file);
  if (!walk) throw std::runtime_error(walk.error().to_string());
  return std::move(*walk);
}

sim::Walk with_stops(const Building& world, const sim::Walk& walk, double step_m) {
  const double pause_s = pause_for(walk.belt);
  sim::Walk out = walk;
  out.steps.clear();
  out.add(sim::Pause{pause_s});
  sim::Walk leg = walk;  // What has been walked so far ends where the next leg begins.
  leg.world = sim::ideal_world();
  leg.steps.clear();
  for (const sim::WalkStep& step : walk.steps) {
    const bool moves = std::holds_alternative<sim::GoTo>(step.action) ||
                       std::holds_alternative<sim::TurnBy>(step.action) ||
                       std::holds_alternative<sim::Face>(step.action);
    if (!moves) {
      if (!std::holds_alternative<sim::Pause>(step.action)) out.steps.push_back(step);
      continue;
    }
    leg.steps = {step};
    const sim::Simulation run = walk_through(world, leg);
    add_leg(world, run, step_m, pause_s, out);
    leg.start = {run.truth.back().room, run.truth.back().pose.position};
    leg.start_heading = run.truth.back().pose.heading;
  }
  return out;
}

std::vector<Stop> find_stops(const Building& world, const sim::Simulation& walk) {
  const auto needed = static_cast<std::size_t>(kPasses * walk.scans.belt.apply_to({}).sensors);
  std::vector<Stop> stops;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= walk.truth.size(); ++i) {
    if (i < walk.truth.size() && still(walk.truth[i], walk.truth[begin])) continue;
    if (i - begin >= needed) {
      const TruthRow& row = walk.truth[begin];
      stops.push_back({begin, world.find_room(row.room), row.pose});
    }
    begin = i;
  }
  return stops;
}

std::vector<Firing> firings_at(const std::vector<Stop>& stops, const sim::Simulation& walk) {
  const auto needed = static_cast<std::ptrdiff_t>(kPasses * walk.scans.belt.apply_to({}).sensors);
  std::vector<Firing> firings;
  for (const Stop& stop : stops) {
    const auto first = walk.scans.firings.begin() + static_cast<std::ptrdiff_t>(stop.first);
    firings.insert(firings.end(), first, first + needed);
  }
  return firings;
}

thesis::Scan scan_at(const Stop& stop, const sim::Simulation& walk, const ThesisParameters& parameters) {
  thesis::ScanAssembler assembler(walk.scans.belt.apply_to({}), parameters);
  for (const Firing& firing : firings_at({stop}, walk)) assembler.add(firing);
  return assembler.scan();
}

}  // namespace echoway::report
