#include "building/frames.hpp"

#include <map>

namespace echoway {
namespace {

constexpr int kUnplaced = -1;

struct Neighbour {
  RoomIndex room = kNoRoom;
  Vec2 here{};
  Vec2 there{};
};

class Placer {
 public:
  explicit Placer(Building& building) : building_(building), pieces_(building.rooms.size(), kUnplaced) {
    neighbours_.resize(building.rooms.size());
    for (const Door& door : building.doors) {
      if (building.room(door.room_a).level != building.room(door.room_b).level) continue;
      of(neighbours_, door.room_a).push_back({door.room_b, door.at_a, door.at_b});
      of(neighbours_, door.room_b).push_back({door.room_a, door.at_b, door.at_a});
    }
  }

  std::vector<int> place(const std::vector<bool>& has_frame) {
    std::map<int, int> piece_of_level;
    for (std::size_t i = 0; i < has_frame.size(); ++i) {
      if (has_frame[i]) start(i, piece_of_level.try_emplace(building_.rooms[i].level, next_piece_).first->second);
    }
    spread();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i] != kUnplaced) continue;
      start(i, next_piece_);
      spread();
    }
    return pieces_;
  }

 private:
  template <class T>
  static T& of(std::vector<T>& list, RoomIndex room) {
    return list[static_cast<std::size_t>(room)];
  }

  void start(std::size_t room, int piece) {
    pieces_[room] = piece;
    next_piece_ = std::max(next_piece_, piece + 1);
    queue_.push_back(static_cast<RoomIndex>(room));
  }

  void spread() {
    for (; done_ < queue_.size(); ++done_) {
      const RoomIndex from = queue_[done_];
      const Pose2 frame = building_.room(from).frame;
      for (const Neighbour& next : of(neighbours_, from)) {
        if (of(pieces_, next.room) != kUnplaced) continue;
        of(building_.rooms, next.room).frame = frame.compose({next.here - next.there, 0.0});
        of(pieces_, next.room) = of(pieces_, from);
        queue_.push_back(next.room);
      }
    }
  }

  Building& building_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<int> pieces_;
  std::vector<RoomIndex> queue_;
  std::size_t done_ = 0;
  int next_piece_ = 0;
};

}  // namespace

std::vector<int> place_rooms(Building& building, const std::vector<bool>& has_frame) {
  std::vector<int> pieces = Placer(building).place(has_frame);
  building.loop_closures.clear();
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const Door& door = building.doors[i];
    const Room& a = building.room(door.room_a);
    const Room& b = building.room(door.room_b);
    if (a.level != b.level) continue;
    const double error = distance(a.frame.transform(door.at_a), b.frame.transform(door.at_b));
    if (error > kClosesWell) building.loop_closures.push_back({i, error});
  }
  return pieces;
}

}  // namespace echoway
