#include "guidance/room_watch.hpp"

#include "guidance/surroundings.hpp"

namespace echoway::guidance {

void RoomWatch::update(const Estimate& e) noexcept {
  constexpr double kClearlyInside = 0.7;
  if (e.room == room_ || e.room_probability < kClearlyInside) return;
  room_ = e.room;
  pending_ = true;
  since_ = e.time_s;
}

void RoomWatch::was_told(RoomIndex room) noexcept {
  room_ = room;
  pending_ = false;
}

void RoomWatch::tell(double now, Announcer& voice) {
  constexpr double kNews = 3.0;  // s
  if (!pending_) return;
  const bool told = voice.offer(room_cue(CueKind::entering, room_), now);
  if (told || now - since_ > kNews) pending_ = false;
}

}  // namespace echoway::guidance
