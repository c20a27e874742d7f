#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "echoway/guidance/guide.hpp"
#include "echoway/random.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::test {

/// A blindfolded wearer who knows nothing but the cues. Every figure is drawn anew for each wearer from these ranges.
struct WearerModel {
  double speed_low = 0.5, speed_high = 1.0;          ///< m/s; blind walkers indoors.
  double reaction_low = 0.4, reaction_high = 1.1;    ///< s, from the end of a line.
  double turn_sigma = degrees(10.0);                 ///< Error of a turn, besides 10 % of its size.
  double step_error = 0.08;                          ///< Share by which a wearer misjudges lengths.
  double veer = degrees(4.0);                        ///< Heading's random walk, per root metre (Guth & LaDuke 1994).
  double patience = 12.0;                            ///< s of standing in silence before asking for the last line.
  double ignore = 0.05;                              ///< Share of the cues that are not taken in.
};

/// Stairs or an elevator being taken.
struct Crossing {
  std::size_t link = 0;   ///< Index into Building::links.
  RoomIndex from = kNoRoom;
  Pose2 leaving{};        ///< In the frame of `from`.
  RoomIndex to = kNoRoom;
  Pose2 arriving{};       ///< In the frame of `to`.
  double begins_s = 0.0;
  double ends_s = 0.0;
};

/// What stands between the wearer and the guide: the truth with noise, or the whole tracker.
class PoseSource {
 public:
  virtual ~PoseSource() = default;
  /// The wearer is at `pose` in `room`, walking at `speed`, at `time_s`. Feeds the guide.
  virtual void observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) = 0;
  /// The wearer is between two levels. By default nothing new is known meanwhile.
  virtual void observe_between(double /*time_s*/, const Crossing& /*crossing*/, Guide& /*guide*/) {}
  /// Takes what the guide has to say of the wearer's way, as advise() does; by default it changes nothing.
  virtual bool heed(Guide& guide) {
    (void)guide.take_level_transition();
    return guide.take_doubt();
  }
  /// What stands in a room and is in no plan; a wearer who walks into it is stopped. In the room's frame.
  [[nodiscard]] virtual std::vector<Segment> things(RoomIndex /*room*/) { return {}; }
};

/// The truth with an error that drifts as a tracker's does (first-order Gauss-Markov, 3 s).
class NoisyTruth : public PoseSource {
 public:
  NoisyTruth(double sigma_m, double sigma_heading, std::uint64_t seed)
      : sigma_m_(sigma_m), sigma_heading_(sigma_heading), random_(seed) {}
  void observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) override;
  /// What the guide was told last.
  [[nodiscard]] const Estimate& estimate() const noexcept { return estimate_; }

 private:
  Estimate estimate_{};
  double sigma_m_;
  double sigma_heading_;
  Random random_;
  Vec2 error_{};
  double heading_error_ = 0.0;
};

struct HeardCue {
  Cue cue;
  bool wrong = false;  ///< It sent the wearer into a wall.
  RoomIndex acted_room = kNoRoom;  ///< Where the wearer did as told,
  Pose2 acted{};
  double wanted = 0.0;             ///< to which side of the chest,
  double reach = 0.0;              ///< and how far it is free there.
};

struct TracePoint {
  double time_s = 0.0;
  RoomIndex room = kNoRoom;
  Pose2 pose{};
};

struct WalkOutcome {
  bool arrived = false;
  double time_s = 0.0;
  double walked_m = 0.0;
  double shortest_m = 0.0;
  int touches = 0;      ///< Times a wall was walked into,
  int bumps = 0;        ///< and times something that no plan knows was.
  int wrong_cues = 0;   ///< Instructions that pointed into a wall.
  int instructions = 0;
  std::vector<double> doubts;  ///< When the guide doubted the place.
  double end_error_m = 0.0;
  std::vector<HeardCue> cues;
  std::vector<std::string> words;  ///< Of the cues, in English.
  std::vector<TracePoint> trace;
};

/// Walks one wearer from `start` to `goal` by cues alone. Gives up after five minutes and the time that a slow walker
/// would need five times over. The same arguments give the same walk. `shortest_m`: the shortest way by the plan unless
/// given.
WalkOutcome walk_blindfolded(const Router& router, const Spot& start, double heading, const Goal& goal,
                             PoseSource& source, const WearerModel& model, std::uint64_t seed,
                             std::optional<double> shortest_m = std::nullopt);

/// A spot at least 0.5 m from walls in a random room.
Spot random_spot(const Router& router, Random& random);

}  // namespace echoway::test
