#include "made_building.hpp"

#include "echoway/building/loader.hpp"
#include "support/plans.hpp"

namespace echoway::proof {

Result<Building> building_of(const std::string& map) {
  if (map == "office") return test::make_office_floor(5);
  if (map == "grid") return test::make_grid(3, 3);
  if (map != "levels") return load_building(map);
  Building b = test::make_office_floor(3);
  Building upper = test::make_office_floor(3);
  const auto base = static_cast<RoomIndex>(b.rooms.size());
  for (Room& room : upper.rooms) {
    room.id.append("-up");
    room.level = 1;
    b.rooms.push_back(room);
  }
  for (Door door : upper.doors) {
    b.doors.push_back({door.room_a + base, door.at_a, door.room_b + base, door.at_b, door.width});
  }
  b.links.push_back({LevelLinkKind::stairs, 0, {0.6, 1.2}, base, {0.6, 1.2}});
  b.links.push_back({LevelLinkKind::elevator, 0, {11.4, 1.2}, base, {11.4, 1.2}});
  return b;
}

}  // namespace echoway::proof
