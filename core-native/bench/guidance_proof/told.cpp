#include "told.hpp"

namespace echoway::proof {

bool leads(const Cue& cue) {
  const auto steers = [](CueKind kind) {
    return kind == CueKind::turn || kind == CueKind::bear || kind == CueKind::go_straight || kind == CueKind::arrived ||
           kind == CueKind::take_link;
  };
  if (cue.urgency == Urgency::broken) return false;
  return steers(cue.kind) || (cue.tail.present && steers(cue.tail.kind));
}

int told_from_wrong_place(const Building& b, const TrackedPose& tracked, const test::WalkOutcome& o) {
  constexpr double kElsewhere = 1.5;  // metres
  int wrong = 0;
  std::size_t told = 0;
  for (const TrackedPose::Entry& e : tracked.diary()) {
    for (; told < o.cues.size() && o.cues[told].cue.time_s <= e.time_s; ++told) {
      const RoomIndex taken = e.estimate.room;
      if (taken == kNoRoom || !leads(o.cues[told].cue)) continue;
      const Vec2 is = b.room(e.room).frame.transform(e.pose.position);
      const Vec2 thought = b.room(taken).frame.transform(e.estimate.pose.position);
      wrong += b.room(e.room).level != b.room(taken).level || distance(is, thought) > kElsewhere ? 1 : 0;
    }
  }
  return wrong;
}

}  // namespace echoway::proof
