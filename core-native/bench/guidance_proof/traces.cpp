#include "traces.hpp"

#include <algorithm>
#include <set>

namespace echoway::proof {

namespace {

void draw_steps(const WalkName& walk, const Building& building, const test::WalkOutcome& o, std::FILE* out) {
  for (const test::TracePoint& p : o.trace) {
    const Vec2 at = building.room(p.room).frame.transform(p.pose.position);
    std::fprintf(out, "%s,%s,%llu,walk,%.3f,%.3f,%d,\n", walk.map.c_str(), walk.source.c_str(),
                 static_cast<unsigned long long>(walk.seed), at.x, at.y, building.room(p.room).level);
  }
}

void draw_things(const WalkName& walk, const Building& building, test::PoseSource& poses, const test::WalkOutcome& o,
                 std::FILE* out) {
  std::set<RoomIndex> seen;
  for (const test::TracePoint& p : o.trace) {
    if (!seen.insert(p.room).second) continue;
    const Room& room = building.room(p.room);
    for (const Segment& s : poses.things(p.room)) {
      const Vec2 a = room.frame.transform(s.a);
      const Vec2 b = room.frame.transform(s.b);
      std::fprintf(out, "%s,%s,%llu,thing,%.3f,%.3f,%d,\"%.3f %.3f\"\n", walk.map.c_str(), walk.source.c_str(),
                   static_cast<unsigned long long>(walk.seed), a.x, a.y, room.level, b.x, b.y);
    }
  }
}

void draw_lines(const WalkName& walk, const Building& building, const test::WalkOutcome& o, std::FILE* out) {
  for (std::size_t i = 0; i < o.cues.size(); ++i) {
    const auto p = std::lower_bound(o.trace.begin(), o.trace.end(), o.cues[i].cue.time_s,
                                    [](const test::TracePoint& t, double s) { return t.time_s < s; });
    if (p == o.trace.end()) continue;
    const Vec2 at = building.room(p->room).frame.transform(p->pose.position);
    std::fprintf(out, "%s,%s,%llu,cue,%.3f,%.3f,%d,\"%s\"\n", walk.map.c_str(), walk.source.c_str(),
                 static_cast<unsigned long long>(walk.seed), at.x, at.y, building.room(p->room).level, o.words[i].c_str());
  }
}

void draw_way(const WalkName& walk, const Building& building, const Route& way, std::FILE* out) {
  for (const Waypoint& w : way.waypoints) {
    const Vec2 at = building.room(w.room).frame.transform(w.at);
    std::fprintf(out, "%s,%s,%llu,way,%.3f,%.3f,%d,\n", walk.map.c_str(), walk.source.c_str(),
                 static_cast<unsigned long long>(walk.seed), at.x, at.y, building.room(w.room).level);
  }
}

}  // namespace

void draw_walls(const std::string& map, const Router& router, std::FILE* out) {
  for (std::size_t r = 0; r < router.building().rooms.size(); ++r) {
    const Room& room = router.building().rooms[r];
    for (const Segment& s : router.space(static_cast<RoomIndex>(r)).solids()) {
      const Vec2 a = room.frame.transform(s.a);
      const Vec2 b = room.frame.transform(s.b);
      std::fprintf(out, "%s,,0,wall,%.3f,%.3f,%d,\"%.3f %.3f\"\n", map.c_str(), a.x, a.y, room.level, b.x, b.y);
    }
  }
}

void draw_walk(const WalkName& walk, const Building& building, const Route& way, test::PoseSource& poses,
               const test::WalkOutcome& o, std::FILE* out) {
  draw_steps(walk, building, o, out);
  draw_things(walk, building, poses, o, out);
  draw_lines(walk, building, o, out);
  draw_way(walk, building, way, out);
}

}  // namespace echoway::proof
