#include "guidance/doorstep.hpp"

#include <algorithm>
#include <cmath>

#include "guidance/doorway.hpp"
#include "guidance/place_change.hpp"

namespace echoway::guidance {
namespace {

constexpr double kDeep = 0.4;  ///< From a door's wall to either side that is still the doorway, metres.

/// The doorway of `room` that a wearer at `position` stands in.
std::optional<Doorway> doorway_at(const Router& router, const GuideConfig& config, RoomIndex room, Vec2 position,
                                  std::int32_t door) noexcept {
  const auto doorway = Doorway::of(router, room, door, config.body_m);
  const bool in_it = doorway && doorway->before(position) < kDeep &&
                     std::abs(doorway->beside(position)) < 0.5 * doorway->width();
  return in_it ? doorway : std::nullopt;
}

}  // namespace

/// The same place in the frame of `room_`, if a doorway joins the two there.
std::optional<Estimate> Doorstep::on_this_side(const Estimate& e) const noexcept {
  const Building& building = router_->building();
  for (const Passage& p : router_->space(room_).passages()) {
    if (building.doors[static_cast<std::size_t>(p.door)].beyond(room_) != e.room) continue;
    const auto there = doorway_at(*router_, *config_, e.room, e.pose.position, p.door);
    const auto here = Doorway::of(*router_, room_, p.door, config_->body_m);
    if (!there || !here) continue;
    const double turn = building.room(e.room).frame.heading - building.room(room_).frame.heading;
    Estimate same = e;
    same.room = room_;
    const Vec2 from_centre = Pose2{{}, turn}.transform(e.pose.position - there->centre());
    same.pose = {here->centre() + from_centre, wrap_angle(e.pose.heading + turn)};
    same.room_probability = 1.0 - e.room_probability;
    return same;
  }
  return std::nullopt;
}

Estimate Doorstep::settle(const Estimate& e) noexcept {
  constexpr double kWalks = 0.25;    // m/s
  constexpr double kSettles = 2.0;   // s: whose walk the tracker took too far is soon put right
  constexpr double kPatience = 3.0;  // s
  if (e.speed_mps > kWalks) walked_s_ = e.time_s;
  const bool known = is_place(router_->building(), e);
  const bool stays = e.time_s - walked_s_ > kSettles && room_ != kNoRoom && known;
  if (stays && e.room != room_) {
    if (other_since_ < 0.0) other_since_ = e.time_s;
    const auto same = on_this_side(e);
    if (same && e.time_s - other_since_ < kPatience) return *same;
  }
  room_ = known ? e.room : kNoRoom;
  other_since_ = -1.0;
  return e;
}

double place_probability(const Router& router, const GuideConfig& config, const Estimate& e,
                         std::span<const Hypothesis> places) noexcept {
  if (places.empty() || places.front().room != e.room || !is_place(router.building(), e)) return e.room_probability;
  const auto& passages = router.space(e.room).passages();
  const bool in_doorway = std::any_of(passages.begin(), passages.end(), [&](const Passage& p) {
    return doorway_at(router, config, e.room, e.pose.position, p.door).has_value();
  });
  return in_doorway ? std::max(e.room_probability, places.front().probability) : e.room_probability;
}

}  // namespace echoway::guidance
