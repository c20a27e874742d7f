// The proof of guidance: blindfolded wearers walk through buildings by cues alone. One row a walk, as CSV.
//   guidance_proof OUT.csv TRACES.csv WALKS SOURCE MAP...
// WALKS: how many; or A-B for walks A to B - 1; or #N for walk N alone, with its diary on the standard output.
// SOURCE: noise (truth with 0.12 m and 4 degrees of drifting error), empty or furnished (the tracker on the simulated
// world's echoes, told where the walk starts), search (the tracker told nothing, in a furnished world), cluttered (as
// furnished, but things stand on the way as well), obstacles (the same with the noisy truth instead of the tracker). A MAP is a
// building's folder, or office, grid, levels for one made here.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "echoway/building/loader.hpp"
#include "support/plans.hpp"
#include "tracked_pose.hpp"

namespace {

using namespace echoway;

Result<Building> building_of(const std::string& map) {
  if (map == "office") return test::make_office_floor(5);
  if (map == "grid") return test::make_grid(3, 3);
  if (map != "levels") return load_building(map);
  Building b = test::make_office_floor(3);
  Building upper = test::make_office_floor(3);
  const auto base = static_cast<RoomIndex>(b.rooms.size());
  for (Room& room : upper.rooms) {
    room.id.append("-up");
    room.level = 1;
    b.rooms.push_back(room);
  }
  for (Door door : upper.doors) b.doors.push_back({door.room_a + base, door.at_a, door.room_b + base, door.at_b, door.width});
  b.links.push_back({LevelLinkKind::stairs, 0, {0.6, 1.2}, base, {0.6, 1.2}});
  b.links.push_back({LevelLinkKind::elevator, 0, {11.4, 1.2}, base, {11.4, 1.2}});
  return b;
}

struct Files {
  std::FILE* rows;
  std::FILE* traces;
  bool diary = false;
};

/// A way of which only the ends are kept free: two stretches of no length, with stairs to each, which lie nowhere.
Route ends_of(const Route& way) {
  Route ends;
  for (const Waypoint& w : {way.waypoints.front(), way.waypoints.back()}) {
    for (const WaypointKind kind : {WaypointKind::link_to, WaypointKind::turn}) {
      ends.waypoints.push_back(w);
      ends.waypoints.back().kind = kind;
    }
  }
  return ends;
}

/// The shortest way for who knows where everything stands; none when there is no room to pass.
std::optional<double> shortest_round_things(const Building& plan, proof::TrackedPose& world, const Spot& start,
                                            const Spot& end) {
  Building furnished = plan;
  for (std::size_t i = 0; i < furnished.rooms.size(); ++i) {
    for (const Segment& s : world.things(static_cast<RoomIndex>(i))) {
      // A post has no length, which a wall needs.
      const Vec2 b = s.length() > 0.0 ? s.b : s.b + Vec2{0.01, 0.0};
      furnished.rooms[i].reflectors.push_back({s.a, b});
    }
  }
  const Router router(furnished);
  const Result<Route> way = router.find_route(start, {Goal::Kind::spot, 0, end});
  if (!way) return std::nullopt;
  return walked_length(*way);
}

/// Lines that tell the wearer which way to move, or that they are there; not what a lost one is asked to do to be found.
bool leads(const Cue& cue) {
  const auto steers = [](CueKind kind) {
    return kind == CueKind::turn || kind == CueKind::bear || kind == CueKind::go_straight || kind == CueKind::arrived ||
           kind == CueKind::take_link;
  };
  if (cue.urgency == Urgency::broken) return false;
  return steers(cue.kind) || (cue.tail.present && steers(cue.tail.kind));
}

/// The noisy truth, with a diary of what it told the guide.
class NotedTruth : public test::NoisyTruth {
 public:
  using NoisyTruth::NoisyTruth;
  void observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) override {
    NoisyTruth::observe(time_s, room, pose, speed, guide);
    diary_.push_back({time_s, room, pose, estimate()});
  }
  [[nodiscard]] const std::vector<proof::TrackedPose::Entry>& diary() const noexcept { return diary_; }

 private:
  std::vector<proof::TrackedPose::Entry> diary_;
};

/// How many lines led the wearer while the tracker took them to be elsewhere: they may send anybody anywhere.
int told_from_wrong_place(const Building& b, const proof::TrackedPose& tracked, const test::WalkOutcome& o) {
  constexpr double kElsewhere = 1.5;  // metres
  int wrong = 0;
  std::size_t told = 0;
  for (const proof::TrackedPose::Entry& e : tracked.diary()) {
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

/// Once a second and at each line: where the wearer was, where the tracker took them to be, and what they heard.
void print_diary(const Building& b, std::span<const proof::TrackedPose::Entry> diary, const test::WalkOutcome& o) {
  constexpr std::array<const char*, 3> kStates{"searching", "tracking", "lost"};
  const auto place = [&](RoomIndex room, const Pose2& pose) {
    std::printf("%-9s %6.2f %6.2f %5.0f", room == kNoRoom ? "-" : b.room(room).id.c_str(), pose.position.x, pose.position.y,
                to_degrees(pose.heading));
  };
  std::size_t told = 0;
  std::size_t doubted = 0;
  double next = 0.0;
  for (const proof::TrackedPose::Entry& e : diary) {
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
    for (; doubted < o.doubts.size() && o.doubts[doubted] <= e.time_s; ++doubted) std::printf("  (the guide doubts the place)");
    std::printf("\n");
  }
}

void walk(const std::string& name, const Router& router, const std::string& source, std::uint64_t seed, Files out) {
  Random random(7000 + seed);
  Spot start = test::random_spot(router, random);
  Spot end = test::random_spot(router, random);
  Result<Route> way = router.find_route(start, {Goal::Kind::spot, 0, end});
  while (!way || way->length_m < 3.0) {  // inside furniture, or no walk at all
    start = test::random_spot(router, random);
    end = test::random_spot(router, random);
    way = router.find_route(start, {Goal::Kind::spot, 0, end});
  }
  const double heading = random.uniform(-kPi, kPi);
  std::optional<double> shortest;
  std::unique_ptr<test::PoseSource> poses;
  proof::TrackedPose* tracked = nullptr;
  NotedTruth* truth = nullptr;
  int barred = -1;  // worlds in which furniture bars every way
  if (source == "noise") {
    auto noted = std::make_unique<NotedTruth>(0.12, degrees(4.0), seed);
    truth = noted.get();
    poses = std::move(noted);
  } else {
    Start known;
    if (source != "search") known = {start.room, start.at, heading};
    const bool in_the_way = source == "obstacles" || source == "cluttered";
    const bool by_truth = source == "obstacles";
    for (std::uint64_t attempt = 0; tracked == nullptr; ++attempt, ++barred) {
      Random of_world(seed + 99 + 1000 * attempt);
      const sim::World world = sim::random_world(source == "empty" ? sim::Profile::empty : sim::Profile::furnished, of_world);
      auto chain = std::make_unique<proof::TrackedPose>(
          router, world, in_the_way ? ends_of(*way) : *way, known, seed + 1000 * attempt,
          by_truth ? std::make_unique<test::NoisyTruth>(0.12, degrees(4.0), seed) : nullptr);
      if (in_the_way) shortest = shortest_round_things(router.building(), *chain, start, end);
      if (in_the_way && !shortest) continue;  // somebody has barred the only way with a cupboard
      tracked = chain.get();
      poses = std::move(chain);
    }
  }
  const test::WalkOutcome o =
      test::walk_blindfolded(router, start, heading, {Goal::Kind::spot, 0, end}, *poses, {}, seed, shortest);
  double error = 0.0;
  double right = 1.0;
  if (tracked != nullptr && !tracked->errors().empty()) {
    error = std::accumulate(tracked->errors().begin(), tracked->errors().end(), 0.0) / static_cast<double>(tracked->errors().size());
    right = tracked->room_right();
  }
  std::fprintf(out.rows, "%s,%s,%llu,%d,%.1f,%.2f,%.2f,%d,%d,%d,%zu,%.2f,%.3f,%.3f,%d,%d,%d,%d\n", name.c_str(), source.c_str(),
               static_cast<unsigned long long>(seed), o.arrived ? 1 : 0, o.time_s, o.walked_m, o.shortest_m, o.touches,
               o.wrong_cues, o.instructions, o.cues.size(), o.end_error_m, error, right, o.bumps,
               tracked != nullptr ? told_from_wrong_place(router.building(), *tracked, o) : 0,
               static_cast<int>(std::count_if(o.cues.begin(), o.cues.end(), [](const test::HeardCue& c) { return leads(c.cue); })),
               std::max(barred, 0));
  std::fflush(out.rows);
  if (out.diary) {
    std::printf("%s %s %llu: %s\n", name.c_str(), source.c_str(), static_cast<unsigned long long>(seed),
                o.arrived ? "arrived" : "failed");
    for (const Waypoint& w : way->waypoints) {
      std::printf("way  %s %.2f %.2f\n", router.building().room(w.room).id.c_str(), w.at.x, w.at.y);
    }
    for (std::size_t r = 0; r < router.building().rooms.size(); ++r) {
      for (const Segment& t : poses->things(static_cast<RoomIndex>(r))) {
        std::printf("thing %s %.2f %.2f  %.2f %.2f\n", router.building().rooms[r].id.c_str(), t.a.x, t.a.y, t.b.x, t.b.y);
      }
    }
    print_diary(router.building(), tracked != nullptr ? tracked->diary() : truth->diary(), o);
  }
  constexpr std::uint64_t kDrawn = 6;
  if (seed >= kDrawn) return;
  for (const test::TracePoint& p : o.trace) {
    const Vec2 at = router.building().room(p.room).frame.transform(p.pose.position);
    std::fprintf(out.traces, "%s,%s,%llu,walk,%.3f,%.3f,%d,\n", name.c_str(), source.c_str(),
                 static_cast<unsigned long long>(seed), at.x, at.y, router.building().room(p.room).level);
  }
  std::set<RoomIndex> seen;
  for (const test::TracePoint& p : o.trace) {
    if (!seen.insert(p.room).second) continue;
    const Room& room = router.building().room(p.room);
    for (const Segment& s : poses->things(p.room)) {
      const Vec2 a = room.frame.transform(s.a);
      const Vec2 b = room.frame.transform(s.b);
      std::fprintf(out.traces, "%s,%s,%llu,thing,%.3f,%.3f,%d,\"%.3f %.3f\"\n", name.c_str(), source.c_str(),
                   static_cast<unsigned long long>(seed), a.x, a.y, room.level, b.x, b.y);
    }
  }
  for (std::size_t i = 0; i < o.cues.size(); ++i) {
    const auto p = std::lower_bound(o.trace.begin(), o.trace.end(), o.cues[i].cue.time_s,
                                    [](const test::TracePoint& t, double s) { return t.time_s < s; });
    if (p == o.trace.end()) continue;
    const Vec2 at = router.building().room(p->room).frame.transform(p->pose.position);
    std::fprintf(out.traces, "%s,%s,%llu,cue,%.3f,%.3f,%d,\"%s\"\n", name.c_str(), source.c_str(),
                 static_cast<unsigned long long>(seed), at.x, at.y, router.building().room(p->room).level, o.words[i].c_str());
  }
  for (const Waypoint& w : way->waypoints) {
    const Vec2 at = router.building().room(w.room).frame.transform(w.at);
    std::fprintf(out.traces, "%s,%s,%llu,way,%.3f,%.3f,%d,\n", name.c_str(), source.c_str(),
                 static_cast<unsigned long long>(seed), at.x, at.y, router.building().room(w.room).level);
  }
}

/// The first walk and the one after the last.
std::pair<int, int> walks_of(const std::string& which) {
  const bool one = which.front() == '#';
  const int number = std::atoi(which.c_str() + (one ? 1 : 0));
  if (one) return {number, number + 1};
  const std::size_t dash = which.find('-');
  return dash == std::string::npos ? std::pair{0, number} : std::pair{number, std::atoi(which.c_str() + dash + 1)};
}

void draw_walls(const std::string& name, const Router& router, std::FILE* out) {
  for (std::size_t r = 0; r < router.building().rooms.size(); ++r) {
    const Room& room = router.building().rooms[r];
    for (const Segment& s : router.space(static_cast<RoomIndex>(r)).solids()) {
      const Vec2 a = room.frame.transform(s.a);
      const Vec2 b = room.frame.transform(s.b);
      std::fprintf(out, "%s,,0,wall,%.3f,%.3f,%d,\"%.3f %.3f\"\n", name.c_str(), a.x, a.y, room.level, b.x, b.y);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) {
    std::fprintf(stderr, "usage: guidance_proof OUT.csv TRACES.csv WALKS SOURCE MAP...\n");
    return 2;
  }
  Files out{std::fopen(argv[1], "a"), std::fopen(argv[2], "a")};
  if (out.rows == nullptr || out.traces == nullptr) return 1;
  const std::string which = argv[3];
  out.diary = which.front() == '#';
  const auto [first, last] = walks_of(which);
  const std::string source = argv[4];
  for (int i = 5; i < argc; ++i) {
    std::string name = argv[i];
    const Result<Building> building = building_of(name);
    if (!building) {
      std::fprintf(stderr, "%s\n", building.error().to_string().c_str());
      return 2;
    }
    name = name.substr(name.find_last_of('/') + 1);
    const Router router(*building);
    draw_walls(name, router, out.traces);
    for (int seed = first; seed < last; ++seed) walk(name, router, source, static_cast<std::uint64_t>(seed), out);
  }
  std::fclose(out.rows);
  std::fclose(out.traces);
  return 0;
}
