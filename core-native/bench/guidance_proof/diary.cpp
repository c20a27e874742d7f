#include "diary.hpp"

#include <array>
#include <cstdio>

namespace echoway::proof {

void print_scene(const Building& b, const Route& way, test::PoseSource& poses) {
  for (const Waypoint& w : way.waypoints) {
    std::printf("way  %s %.2f %.2f\n", b.room(w.room).id.c_str(), w.at.x, w.at.y);
  }
  for (std::size_t r = 0; r < b.rooms.size(); ++r) {
    for (const Segment& t : poses.things(static_cast<RoomIndex>(r))) {
      std::printf("thing %s %.2f %.2f  %.2f %.2f\n", b.rooms[r].id.c_str(), t.a.x, t.a.y, t.b.x, t.b.y);
    }
  }
}

void print_diary(const Building& b, std::span<const TrackedPose::Entry> diary, const test::WalkOutcome& o) {
  constexpr std::array<const char*, 3> kStates{"searching", "tracking", "lost"};
  const auto place = [&](RoomIndex room, const Pose2& pose) {
    std::printf("%-9s %6.2f %6.2f %5.0f", room == kNoRoom ? "-" : b.room(room).id.c_str(), pose.position.x,
                pose.position.y, to_degrees(pose.heading));
  };
  std::size_t told = 0;
  std::size_t doubted = 0;
  double next = 0.0;
  for (const TrackedPose::Entry& e : diary) {
    const bool speaks = told < o.cues.size() && o.cues[told].cue.time_s <= e.time_s;
    if (!speaks && e.time_s < next) continue;
    next = e.time_s + 1.0;
    std::printf("%6.1f  ", e.time_s);
    place(e.room, e.pose);
    std::printf("  | ");
    place(e.estimate.room, e.estimate.pose);
    std::printf("  %4.2f m %3.0f %% %.2f m/s %-9s", e.estimate.sigma_m, 100.0 * e.estimate.room_probability,
                e.estimate.speed_mps, kStates[static_cast<std::size_t>(e.estimate.state)]);
    for (; told < o.cues.size() && o.cues[told].cue.time_s <= e.time_s; ++told) {
      std::printf("  %s", o.words[told].c_str());
      const test::HeardCue& heard = o.cues[told];
      if (!heard.wrong) continue;
      std::printf(" (AT A WALL: done at ");
      place(heard.acted_room, heard.acted);
      std::printf(", %.0f from the chest, %.2f m)", to_degrees(heard.wanted), heard.reach);
    }
    for (; doubted < o.doubts.size() && o.doubts[doubted] <= e.time_s; ++doubted) {
      std::printf("  (the guide doubts the place)");
    }
    std::printf("\n");
  }
}

}  // namespace echoway::proof
