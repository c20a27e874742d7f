#include "traces.hpp"

#include <algorithm>
#include <set>

namespace echoway::proof {

namespace {

void add(const WalkName& walk, std::string_view kind, Vec2 at, int level, const std::string& text,
         report::TableFile& out) {
  out.add(walk.map, walk.source, walk.seed, kind, report::fixed(at.x, 3), report::fixed(at.y, 3), level, text);
}

std::string other_end(Vec2 at) { return fmt::format("\"{:.3f} {:.3f}\"", at.x, at.y); }

void draw_steps(const WalkName& walk, const Building& building, const test::WalkOutcome& o, report::TableFile& out) {
  for (const test::TracePoint& p : o.trace) {
    const Vec2 at = building.room(p.room).frame.transform(p.pose.position);
    add(walk, "walk", at, building.room(p.room).level, "", out);
  }
}

void draw_things(const WalkName& walk, const Building& building, test::PoseSource& poses, const test::WalkOutcome& o,
                 report::TableFile& out) {
  std::set<RoomIndex> seen;
  for (const test::TracePoint& p : o.trace) {
    if (!seen.insert(p.room).second) continue;
    const Room& room = building.room(p.room);
    for (const Segment& s : poses.things(p.room)) {
      const Vec2 a = room.frame.transform(s.a);
      const Vec2 b = room.frame.transform(s.b);
      add(walk, "thing", a, room.level, other_end(b), out);
    }
  }
}

void draw_lines(const WalkName& walk, const Building& building, const test::WalkOutcome& o, report::TableFile& out) {
  for (std::size_t i = 0; i < o.cues.size(); ++i) {
    const auto p = std::lower_bound(o.trace.begin(), o.trace.end(), o.cues[i].cue.time_s,
                                    [](const test::TracePoint& t, double s) { return t.time_s < s; });
    if (p == o.trace.end()) continue;
    const Vec2 at = building.room(p->room).frame.transform(p->pose.position);
    add(walk, "cue", at, building.room(p->room).level, '"' + o.words[i] + '"', out);
  }
}

void draw_way(const WalkName& walk, const Building& building, const Route& way, report::TableFile& out) {
  for (const Waypoint& w : way.waypoints) {
    const Vec2 at = building.room(w.room).frame.transform(w.at);
    add(walk, "way", at, building.room(w.room).level, "", out);
  }
}

}  // namespace

void draw_walls(const std::string& map, const Router& router, report::TableFile& out) {
  for (std::size_t r = 0; r < router.building().rooms.size(); ++r) {
    const Room& room = router.building().rooms[r];
    for (const Segment& s : router.space(static_cast<RoomIndex>(r)).solids()) {
      const Vec2 a = room.frame.transform(s.a);
      const Vec2 b = room.frame.transform(s.b);
      add({map, "", 0}, "wall", a, room.level, other_end(b), out);
    }
  }
}

void draw_walk(const WalkName& walk, const Building& building, const Route& way, test::PoseSource& poses,
               const test::WalkOutcome& o, report::TableFile& out) {
  draw_steps(walk, building, o, out);
  draw_things(walk, building, poses, o, out);
  draw_lines(walk, building, o, out);
  draw_way(walk, building, way, out);
}

}  // namespace echoway::proof
