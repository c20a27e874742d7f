#include <algorithm>
#include <cmath>
#include <numeric>

#include "building/features.hpp"
#include "building/lint.hpp"
#include "building/phrases.hpp"
#include "echoway/geometry/inclusion.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

/// Ends that had to be moved by more than rounding.
constexpr double kWorthSaying = 0.01;

/// Two walls on one line within this distance are drawn over each other.
constexpr double kSameLine = 0.01;
constexpr double kLeastOverlap = 0.1;

/// Ground cut off from the floor by less than this is a column or a shaft, square metres.
constexpr double kCutOffRoom = 2.0;

/// A listed corner this near to where walls meet was meant to be there.
constexpr double kMeantToMeet = feet(1.0);

class RoomLint {
 public:
  RoomLint(const Assembly& assembly, std::size_t room, Findings& findings)
      : source_(assembly.source.rooms[room]),
        room_(assembly.building.rooms[room]),
        floor_(assembly.floors[room]),
        lines_(assembly.wall_lines[room]),
        phrases_(assembly.building.unit),
        findings_(findings) {}

  void run() {
    if (!source_.readable || !floor_.closed) return;
    lint_snapped_ends();
    lint_overdrawn_walls();
    lint_stray_elements();
    lint_corners();
    lint_edges();
    lint_missing();
  }

 private:
  void warn(Kind kind, int line, std::string message) { findings_.warn(kind, source_.file, line, std::move(message)); }

  void lint_snapped_ends() {
    for (const SnappedEnd& end : floor_.snapped) {
      if (end.moved <= kWorthSaying) continue;
      warn(Kind::wall_end, lines_[end.wall],
           "the wall ends at " + phrases_.point(end.at) + ", " + phrases_.length(end.moved) +
               " from another wall, and is taken to meet it; move its end there");
    }
  }

  void lint_overdrawn_walls() {
    std::vector<std::size_t> order(room_.walls.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto left = [&](std::size_t i) { return std::min(room_.walls[i].a.x, room_.walls[i].b.x); };
    const auto right = [&](std::size_t i) { return std::max(room_.walls[i].a.x, room_.walls[i].b.x); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return left(i) < left(j); });
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (std::size_t m = k + 1; m < order.size() && left(order[m]) <= right(order[k]) + kSameLine; ++m) {
        const auto [first, second] = std::minmax({order[k], order[m]});
        const double common = common_length(room_.walls[first], room_.walls[second]);
        if (common <= kLeastOverlap) continue;
        warn(Kind::repeated, lines_[second],
             "the wall runs over the wall on line " + std::to_string(lines_[first]) + " for " +
                 phrases_.length(common) + "; draw that stretch once");
      }
    }
  }

  /// Length that two walls on one line have in common.
  static double common_length(const Segment& p, const Segment& q) {
    const double length = p.length();
    const Vec2 along = (1.0 / length) * p.direction();
    const double off = std::max(std::abs(cross(along, q.a - p.a)), std::abs(cross(along, q.b - p.a)));
    const auto [low, high] = std::minmax({dot(along, q.a - p.a), dot(along, q.b - p.a)});
    return off > kSameLine ? 0.0 : std::min(high, length) - std::max(low, 0.0);
  }

  void lint_stray_elements() {
    for (const std::size_t wall : floor_.outside_walls) {
      warn(Kind::off_floor, lines_[wall],
           "the wall stands outside the floor that the other walls enclose, where no echo finds it; "
           "remove it or close the outline around it");
    }
    for (const Located<Segment>& reflector : source_.reflectors) {
      const Segment& s = reflector.what;
      if (contains(room_.boundary, s.a) || contains(room_.boundary, s.b)) continue;
      if (contains(room_.boundary, 0.5 * (s.a + s.b))) continue;
      warn(Kind::off_floor, reflector.line,
           "the reflector stands outside the room's floor, where no echo finds it; move or remove it");
    }
    if (floor_.cut_off_area > kCutOffRoom) {
      warn(Kind::cut_off, source_.counts_line,
           "walls cut " + phrases_.area(floor_.cut_off_area) +
               " off from the floor, and only the larger part counts; if one can walk there, "
               "make it a room of its own with a door");
    }
  }

  void lint_corners() {
    std::vector<Vec2> seen;
    for (const Located<Vec2>& listed : source_.corners) {
      lint_repeated(listed, seen, "corner");
      const FeaturePlace place = place_feature(floor_, listed.what);
      if (place.corner || place.oblique) continue;
      const std::string here = "the corner at " + phrases_.point(listed.what);
      if (place.edge) {
        warn(Kind::corner_or_edge, listed.line,
             here + " is an edge, since the walls turn away from the floor there; write '3 x y'");
      } else {
        warn(Kind::corner_or_edge, listed.line,
             here + " is not where two walls make a corner; " + where_instead(listed.what));
      }
    }
  }

  [[nodiscard]] std::string where_instead(Vec2 listed) const {
    const WallMeeting* nearest = nullptr;
    for (const WallMeeting& meeting : floor_.meetings) {
      const MeetingKind kind = kind_of(meeting);
      if (kind != MeetingKind::corner && kind != MeetingKind::oblique) continue;
      if (nearest == nullptr || distance(meeting.at, listed) < distance(nearest->at, listed)) nearest = &meeting;
    }
    if (nearest == nullptr || distance(nearest->at, listed) > kMeantToMeet) return "move or remove it";
    return "the nearest is at " + phrases_.point(nearest->at) + ", move it there";
  }

  void lint_edges() {
    std::vector<Vec2> seen;
    for (const Located<Vec2>& listed : source_.edges) {
      lint_repeated(listed, seen, "edge");
      const FeaturePlace place = place_feature(floor_, listed.what);
      const std::string here = "the edge at " + phrases_.point(listed.what);
      if (place.edge) continue;
      if (place.corner || place.oblique) {
        warn(Kind::corner_or_edge, listed.line,
             here + " is a corner, since the walls turn towards the floor there; write '2 x y'");
      } else if (!is_on_an_element(listed.what)) {
        warn(Kind::corner_or_edge, listed.line,
             here + " stands on no wall; move it to a door frame or to where walls turn away, or remove it");
      }
    }
  }

  [[nodiscard]] bool is_on_an_element(Vec2 p) const {
    const auto near = [&](const Segment& s) { return distance(s, p) <= kSameFeature; };
    return std::any_of(room_.walls.begin(), room_.walls.end(), near) ||
           std::any_of(room_.reflectors.begin(), room_.reflectors.end(), near);
  }

  void lint_repeated(const Located<Vec2>& listed, std::vector<Vec2>& seen, std::string_view what) {
    const bool repeated = is_listed(seen, listed.what);
    if (repeated) {
      warn(
          Kind::repeated, listed.line,
          "the " + std::string(what) + " at " + phrases_.point(listed.what) + " is listed already; remove one of them");
    }
    seen.push_back(listed.what);
  }

  static bool is_listed(const std::vector<Vec2>& points, Vec2 p) {
    return std::any_of(points.begin(), points.end(), [&](Vec2 q) { return distance(p, q) <= kSameFeature; });
  }

  /// A file that lists corners should list all of them; one that lists none leaves them to us. Edges likewise.
  void lint_missing() {
    std::vector<Vec2> listed;
    for (const auto* points : {&source_.corners, &source_.edges}) {
      for (const Located<Vec2>& point : *points) listed.push_back(point.what);
    }
    for (const WallMeeting& meeting : floor_.meetings) {
      const MeetingKind kind = kind_of(meeting);
      const bool corner = kind == MeetingKind::corner && !source_.corners.empty();
      const bool edge = kind == MeetingKind::edge && !source_.edges.empty();
      if ((!corner && !edge) || is_listed(listed, meeting.at)) continue;
      listed.push_back(meeting.at);
      const std::string at = phrases_.point(meeting.at);
      warn(Kind::corner_or_edge, source_.counts_line,
           corner ? "the corner at " + at + " is missing and is derived; add '2 x y' for it"
                  : "the edge at " + at + " is missing and is derived; add '3 x y' for it");
    }
  }

  const RoomSource& source_;
  const Room& room_;
  const FloorTrace& floor_;
  const std::vector<int>& lines_;
  Phrases phrases_;
  Findings& findings_;
};

}  // namespace

void lint_rooms(const Assembly& assembly, Findings& findings) {
  for (std::size_t i = 0; i < assembly.building.rooms.size(); ++i) RoomLint(assembly, i, findings).run();
}

}  // namespace echoway
