#include "scene/floor_world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "echoway/geometry/inclusion.hpp"
#include "streams.hpp"

namespace echoway::sim {
namespace {

constexpr double kStride = 0.1;      // Between the places of a footprint, metres.
constexpr double kLeafClear = 0.35;  // A door's leaf stays this far from the wearer's way, metres.

}  // namespace

void Footprint::step_on(RoomIndex room, Vec2 at) {
  std::vector<Vec2>& of_room = places[room];
  if (of_room.empty() || distance(of_room.back(), at) > kStride) of_room.push_back(at);
}

FloorWorld::FloorWorld(const FloorPlan& plan, Footprint footprint, const World& world, std::uint64_t seed)
    : plan_(plan), world_(world), seed_(seed), footprint_(std::move(footprint)) {
  for (std::size_t door = 0; door < plan.building().doors.size(); ++door) {
    if (footprint_.doors.contains(door)) continue;
    if (stream(seed_, Stream::door_shut, door).uniform() < world.doors_shut) shut_.insert(door);
  }
}

const View& FloorWorld::view_from(RoomIndex room) {
  const auto known = views_.find(room);
  if (known != views_.end()) return known->second;
  return views_.emplace(room, View(room, *this)).first->second;
}

void FloorWorld::set_door(std::size_t door, bool open) {
  if (open) {
    shut_.erase(door);
  } else {
    shut_.insert(door);
  }
  views_.clear();
}

const std::vector<Doorway>& FloorWorld::doorways(RoomIndex room) const { return plan_.doorways(room); }

const RoomScene& FloorWorld::scene(RoomIndex room) {
  const auto known = scenes_.find(room);
  if (known != scenes_.end()) return known->second;
  const Random random = stream(seed_, Stream::room, static_cast<std::uint64_t>(room));
  return scenes_
      .emplace(room, build_room_scene(plan_.building().room(room), plan_.doorways(room), world_,
                                      footprint_.places[room], random))
      .first->second;
}

bool FloorWorld::is_open(std::size_t door) const { return !shut_.contains(door); }

std::optional<Segment> FloorWorld::leaf(RoomIndex room, const Doorway& doorway) {
  Random random = stream(seed_, Stream::door_leaf, doorway.door);
  const bool present = random.uniform() < world_.door_leaves;
  const bool into_a = random.uniform() < 0.5;
  const bool hinge_first = random.uniform() < 0.5;
  const double angle = random.uniform(degrees(60.0), degrees(120.0));
  if (!present || into_a != (room == plan_.building().doors[doorway.door].room_a)) return std::nullopt;
  const Vec2 hinge = hinge_first ? doorway.opening.a : doorway.opening.b;
  const Vec2 closed = (hinge_first ? 1.0 : -1.0) * doorway.along();
  const Vec2 tip = hinge + doorway.width() * (std::cos(angle) * closed + std::sin(angle) * doorway.inward);
  const Segment leaf{hinge + 0.02 * doorway.inward, tip};
  const std::vector<Vec2>& way = footprint_.places[room];
  const bool in_the_way = std::any_of(way.begin(), way.end(), [&](Vec2 p) { return distance(leaf, p) < kLeafClear; });
  if (in_the_way || !contains(plan_.building().room(room).boundary, tip)) return std::nullopt;
  return leaf;
}

}  // namespace echoway::sim
