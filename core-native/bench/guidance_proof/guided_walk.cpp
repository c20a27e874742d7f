#include "guided_walk.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "diary.hpp"
#include "support/blind_walk.hpp"
#include "told.hpp"
#include "traces.hpp"
#include "tracked_pose.hpp"
#include "ways.hpp"

namespace echoway::proof {
namespace {

/// The noisy truth, with a diary of what it told the guide.
class NotedTruth : public test::NoisyTruth {
 public:
  using NoisyTruth::NoisyTruth;
  void observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) override {
    NoisyTruth::observe(time_s, room, pose, speed, guide);
    diary_.push_back({time_s, room, pose, estimate()});
  }
  [[nodiscard]] const std::vector<TrackedPose::Entry>& diary() const noexcept { return diary_; }

 private:
  std::vector<TrackedPose::Entry> diary_;
};

struct Task {
  Spot start;
  Spot end;
  Route way;
};

Task draw_task(const Router& router, Random& random) {
  while (true) {
    const Spot start = test::random_spot(router, random);
    const Spot end = test::random_spot(router, random);
    Result<Route> way = router.find_route(start, {Goal::Kind::spot, 0, end});
    if (way && way->length_m >= 3.0) return {start, end, std::move(*way)};  // else inside furniture, or no walk at all
  }
}

void write_row(const WalkName& walk, const Building& building, const TrackedPose* tracked, const test::WalkOutcome& o,
               int barred, report::TableFile& rows) {
  double error = 0.0;
  double right = 1.0;
  if (tracked != nullptr && !tracked->errors().empty()) {
    const auto& errors = tracked->errors();
    error = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    right = tracked->room_right();
  }
  const auto leading =
      std::count_if(o.cues.begin(), o.cues.end(), [](const test::HeardCue& c) { return leads(c.cue); });
  using report::fixed;
  rows.add(walk.map, walk.source, walk.seed, o.arrived ? 1 : 0, fixed(o.time_s, 1), fixed(o.walked_m, 2),
           fixed(o.shortest_m, 2), o.touches, o.wrong_cues, o.instructions, o.cues.size(), fixed(o.end_error_m, 2),
           fixed(error, 3), fixed(right, 3), o.bumps,
           tracked != nullptr ? told_from_wrong_place(building, *tracked, o) : 0, leading, barred);
}

}  // namespace

void walk(const std::string& name, const Router& router, const std::string& source, std::uint64_t seed, Files& out) {
  Random random(7000 + seed);
  const auto [start, end, way] = draw_task(router, random);
  const double heading = random.uniform(-kPi, kPi);
  std::optional<double> shortest;
  std::unique_ptr<test::PoseSource> poses;
  TrackedPose* tracked = nullptr;
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
      const auto profile = source == "empty" ? sim::Profile::empty : sim::Profile::furnished;
      const sim::World world = sim::random_world(profile, of_world);
      auto chain = std::make_unique<TrackedPose>(
          router, world, in_the_way ? ends_of(way) : way, known, seed + 1000 * attempt,
          by_truth ? std::make_unique<test::NoisyTruth>(0.12, degrees(4.0), seed) : nullptr);
      if (in_the_way) shortest = shortest_round_things(router.building(), *chain, start, end);
      if (in_the_way && !shortest) continue;  // somebody has barred the only way with a cupboard
      tracked = chain.get();
      poses = std::move(chain);
    }
  }
  const test::WalkOutcome o =
      test::walk_blindfolded(router, start, heading, {Goal::Kind::spot, 0, end}, *poses, {}, seed, shortest);
  write_row({name, source, seed}, router.building(), tracked, o, std::max(barred, 0), out.rows);
  if (out.diary) {
    std::printf("%s %s %llu: %s\n", name.c_str(), source.c_str(), static_cast<unsigned long long>(seed),
                o.arrived ? "arrived" : "failed");
    print_scene(router.building(), way, *poses);
    print_diary(router.building(), tracked != nullptr ? tracked->diary() : truth->diary(), o);
  }
  constexpr std::uint64_t kDrawn = 6;
  if (seed < kDrawn) draw_walk({name, source, seed}, router.building(), way, *poses, o, out.traces);
}

}  // namespace echoway::proof
