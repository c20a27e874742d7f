#include <algorithm>
#include <map>
#include <numeric>

#include "building/lint.hpp"
#include "building/phrases.hpp"
#include "geometry/overlap.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

/// A loop of doors may miss by a wall's thickness; more is a mistake in some position.
constexpr double kLoopMiss = feet(1.0);

/// Floors may share this much ground by rounding and snapping.
constexpr double kOverlapDepth = kSnapDistance;

/// After so many overlaps something is wrong with the building as a whole.
constexpr int kMaxOverlaps = 100;

class LevelLint {
 public:
  LevelLint(const Assembly& assembly, Findings& findings)
      : assembly_(assembly), building_(assembly.building), phrases_(assembly.building.unit), findings_(findings) {}

  void run() {
    lint_reach();
    lint_pieces();
    lint_loops();
    lint_overlaps();
  }

 private:
  void warn_room(Kind kind, std::size_t room, std::string message) {
    const RoomSource& source = assembly_.source.rooms[room];
    findings_.warn(kind, source.file, source.counts_line, std::move(message));
  }

  /// Rooms that cannot be reached from where most rooms are.
  void lint_reach() {
    std::vector<std::size_t> parent(building_.rooms.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto find = [&](std::size_t r) {
      while (parent[r] != r) r = parent[r] = parent[parent[r]];
      return r;
    };
    const auto join = [&](RoomIndex a, RoomIndex b) {
      parent[find(static_cast<std::size_t>(b))] = find(static_cast<std::size_t>(a));
    };
    for (const Door& door : building_.doors) join(door.room_a, door.room_b);
    for (const LevelLink& link : building_.links) join(link.room_a, link.room_b);
    // Outdoors joins all ways out: a shop with a door to the street only is reached from there.
    for (const Landmark& exit : building_.exits) join(building_.exits.front().room, exit.room);
    std::vector<std::size_t> size(parent.size(), 0);
    for (std::size_t r = 0; r < parent.size(); ++r) ++size[find(r)];
    const auto most = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    reachable_.resize(parent.size());
    for (std::size_t r = 0; r < parent.size(); ++r) {
      reachable_[r] = find(r) == most;
      if (!reachable_[r]) {
        warn_room(Kind::unreachable, r,
                  "no door, stairs or elevator reaches room '" + building_.rooms[r].id +
                      "' from the other rooms; add its door to building.cfg");
      }
    }
  }

  /// Rooms whose place on their level is not known.
  void lint_pieces() {
    std::map<int, std::map<int, int>> size_of_piece;  // by level
    for (std::size_t r = 0; r < building_.rooms.size(); ++r) {
      ++size_of_piece[building_.rooms[r].level][assembly_.pieces[r]];
    }
    for (std::size_t r = 0; r < building_.rooms.size(); ++r) {
      const auto& pieces = size_of_piece[building_.rooms[r].level];
      const auto main = std::max_element(pieces.begin(), pieces.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      if (!reachable_[r] || assembly_.pieces[r] == main->first) continue;
      warn_room(Kind::no_place, r,
                "no door joins room '" + building_.rooms[r].id + "' to the rest of level " +
                    std::to_string(building_.rooms[r].level) +
                    ", so its place there is unknown; add a 'frame' line for it");
    }
  }

  void lint_loops() {
    for (const LoopClosure& loop : building_.loop_closures) {
      if (loop.error <= kLoopMiss) continue;
      const Door& door = building_.doors[loop.door];
      findings_.warn(Kind::door_loop, assembly_.source.config.file, assembly_.door_lines[loop.door].line,
                     "the way round through other rooms puts the two sides of the door between rooms '" +
                         building_.room(door.room_a).id + "' and '" + building_.room(door.room_b).id + "' " +
                         phrases_.length(loop.error) + " apart; correct the positions of the doors on the way");
    }
  }

  struct Placed {
    std::size_t room = 0;
    Vec2 low{};
    Vec2 high{};
    std::vector<std::vector<Vec2>> floor;
  };

  [[nodiscard]] Placed place(std::size_t room) const {
    const Room& r = building_.rooms[room];
    Placed out{room, r.frame.transform(r.boundary.at(0).at(0)), {}, r.boundary};
    out.high = out.low;
    for (std::vector<Vec2>& loop : out.floor) {
      for (Vec2& p : loop) {
        p = r.frame.transform(p);
        out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y)};
        out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y)};
      }
    }
    return out;
  }

  void lint_overlaps() {
    std::map<int, std::vector<Placed>> by_piece;
    for (std::size_t r = 0; r < building_.rooms.size(); ++r) by_piece[assembly_.pieces[r]].push_back(place(r));
    int found = 0;
    for (auto& [piece, rooms] : by_piece) {
      std::sort(rooms.begin(), rooms.end(), [](const Placed& a, const Placed& b) { return a.low.x < b.low.x; });
      for (std::size_t i = 0; i < rooms.size() && found < kMaxOverlaps; ++i) {
        for (std::size_t k = i + 1; k < rooms.size() && rooms[k].low.x < rooms[i].high.x; ++k) {
          if (rooms[k].low.y >= rooms[i].high.y || rooms[i].low.y >= rooms[k].high.y) continue;
          if (!floors_overlap(rooms[i].floor, rooms[k].floor, kOverlapDepth)) continue;
          ++found;
          const auto [first, second] = std::minmax({rooms[i].room, rooms[k].room});
          warn_room(Kind::overlap, second,
                    "room '" + building_.rooms[second].id + "' overlaps room '" + building_.rooms[first].id +
                        "' on level " + std::to_string(building_.rooms[first].level) +
                        "; correct the positions of the doors that lead there, or a 'frame' line");
        }
      }
    }
  }

  const Assembly& assembly_;
  const Building& building_;
  Phrases phrases_;
  Findings& findings_;
  std::vector<bool> reachable_;
};

}  // namespace

void lint_levels(const Assembly& assembly, Findings& findings) { LevelLint(assembly, findings).run(); }

}  // namespace echoway
