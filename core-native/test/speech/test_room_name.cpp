#include "echoway/speech/room_name.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "support/plans.hpp"

namespace echoway {
namespace {

using Called = std::pair<std::string, std::string>;

Called called(const std::string& id, const std::string& name) {
  const RoomName room = room_name(test::make_box(id, 8, 6, name));
  return {room.number, room.name};
}

TEST(RoomName, IsTheIdAndTheNameWhereNeitherWasMadeOfTheOther) {
  EXPECT_EQ(called("2", "Corridor"), Called("2", "Corridor"));
  EXPECT_EQ(called("2", "Room 2"), Called("2", "Room 2"));
  EXPECT_EQ(called("3", "Küche"), Called("3", "Küche"));
  EXPECT_EQ(called("2", ""), Called("2", ""));
}

TEST(RoomName, IsTheNameAloneWhereTheIdWasMadeOfIt) {
  EXPECT_EQ(called("2-main-corridor", "Main corridor"), Called("", "Main corridor"));
  EXPECT_EQ(called("hall", "Hall"), Called("", "Hall"));
  EXPECT_EQ(called("2-3d-lab", "3D lab"), Called("", "3D lab"));
  EXPECT_EQ(called("Küche", "Küche"), Called("", "Küche"));
}

TEST(RoomName, IsTheNumberOnTheDoor) {
  EXPECT_EQ(called("2-2-07", "2.07"), Called("2.07", ""));
  EXPECT_EQ(called("2-b-12", "B 12"), Called("B 12", ""));
  EXPECT_EQ(called("4", "4"), Called("4", ""));
}

TEST(RoomName, LeavesOutTheLevelOfARoomWithoutAName) {
  EXPECT_EQ(called("1-room-7", ""), Called("7", ""));
  EXPECT_EQ(called("g-room-12-2", ""), Called("12-2", ""));
  EXPECT_EQ(called("break-room-b", ""), Called("break-room-b", ""));
  EXPECT_EQ(called("1-room-", ""), Called("1-room-", ""));
}

}  // namespace
}  // namespace echoway
