#include "byte_writer.hpp"
#include "echoway/speech/room_name.hpp"
#include "layouts.hpp"
#include "write_list.hpp"

namespace echoway::jni {
namespace {

void write_room(ByteWriter& w, const Room& room) noexcept {
  w.text(room.id);
  w.text(room.name);
  const RoomName aloud = room_name(room);
  w.text(aloud.number);
  w.text(aloud.name);
  w.i32(room.level);
  write(w, room.frame.position);
  w.f64(room.frame.heading);
  write_list(w, room.walls, [&](const Segment& wall) {
    write(w, wall.a);
    write(w, wall.b);
  });
  write_list(w, room.boundary, [&](const std::vector<Vec2>& loop) {
    write_list(w, loop, [&](Vec2 point) { write(w, point); });
  });
}

void write_end(ByteWriter& w, RoomIndex room, Vec2 at) noexcept {
  w.i32(room);
  write(w, at);
}

void write_landmarks(ByteWriter& w, const std::vector<Landmark>& landmarks) noexcept {
  write_list(w, landmarks, [&](const Landmark& landmark) {
    write_end(w, landmark.room, landmark.at);
    w.text(landmark.name);
  });
}

}  // namespace

std::size_t write_plan(const Building& building, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  w.text(building.name);
  write_list(w, building.rooms, [&](const Room& room) { write_room(w, room); });
  write_list(w, building.doors, [&](const Door& door) {
    write_end(w, door.room_a, door.at_a);
    write_end(w, door.room_b, door.at_b);
    w.f64(door.width);
  });
  write_list(w, building.links, [&](const LevelLink& link) {
    w.i32(static_cast<std::int32_t>(link.kind));
    write_end(w, link.room_a, link.at_a);
    write_end(w, link.room_b, link.at_b);
  });
  write_landmarks(w, building.exits);
  write_landmarks(w, building.places);
  return w.size();
}

}  // namespace echoway::jni
