#include "thesis/exits.hpp"

namespace echoway::thesis {

std::vector<std::vector<Exit>> exits_of(const Building& building) {
  std::vector<std::vector<Exit>> exits(building.rooms.size());
  const auto add = [&](RoomIndex from, Vec2 at, RoomIndex to, Vec2 there) {
    if (!building.has_room(from) || !building.has_room(to) || from == to || !is_finite(at) || !is_finite(there)) return;
    // Positions are taken over at the door itself, not through the level's frame: a loop of rooms that fails to close
    // then does no harm.
    const double turn = wrap_angle(building.room(from).frame.heading - building.room(to).frame.heading);
    const Pose2 rotation{{}, turn};
    exits[static_cast<std::size_t>(from)].push_back({at, to, {there - rotation.transform(at), turn}});
  };
  for (const Door& door : building.doors) {
    add(door.room_a, door.at_a, door.room_b, door.at_b);
    add(door.room_b, door.at_b, door.room_a, door.at_a);
  }
  for (const LevelLink& link : building.links) {
    add(link.room_a, link.at_a, link.room_b, link.at_b);
    add(link.room_b, link.at_b, link.room_a, link.at_a);
  }
  return exits;
}

}  // namespace echoway::thesis
