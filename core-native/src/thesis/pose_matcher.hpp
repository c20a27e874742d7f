#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "echoway/acoustics/range_model.hpp"
#include "echoway/thesis/parameters.hpp"
#include "thesis/floor.hpp"
#include "thesis/objective.hpp"
#include "thesis/scan.hpp"

namespace echoway::thesis {

/// Which poses of one room are postulated.
struct Bounds {
  Vec2 centre{};
  double radius = std::numeric_limits<double>::infinity();  ///< Infinite: the whole room.
  double heading = 0.0;
  double half_turn = kPi;                                   ///< To either side of `heading`; pi: all.

  [[nodiscard]] bool whole_room() const noexcept { return !(radius < 1e300); }
};

/// The best of the postulated poses.
struct Match {
  bool found = false;           ///< False when no pose has readings enough to compare.
  Pose2 pose{};
  double objective_m = 0.0;
  double quality = 0.0;         ///< The objective over the room's greatest range (section 6.2.1, figure 6.10).
  int candidates = 0;           ///< Poses that were scored.
  // How far apart the poses lie that match about as well.
  double spread_xx = 0.0;       ///< Square metres.
  double spread_xy = 0.0;
  double spread_yy = 0.0;
  double spread_heading = 0.0;  ///< Square radians.
};

/// One of several places that explain a scan.
struct Mode {
  RoomIndex room = kNoRoom;
  Pose2 pose{};
  double objective_m = std::numeric_limits<double>::infinity();
};

/// How fine a grid of poses is.
struct Grid {
  double spacing = 0.0;  ///< Of positions, metres.
  int sensor_step = 1;   ///< Headings to one sensor's spacing.
};

/// Scratch memory for matching, one a thread; sized once so that matching allocates nothing.
class MatchWorkspace {
 public:
  MatchWorkspace(const BeltConfig& belt, const ThesisParameters& parameters);

 private:
  friend class PoseMatcher;
  struct Offset {
    double x = 0.0;
    double y = 0.0;
    double distance = 0.0;
  };
  std::vector<Offset> offsets_;  ///< The grid of positions about the centre, nearest first, in spacings.
  Directions directions_;
  PositionEchoes echoes_;
};

/// Matches scans with one room: postulates poses, simulates what the belt would read there and keeps the best
/// (thesis section 5.1).
class PoseMatcher {
 public:
  PoseMatcher(const Room& room, const std::vector<Opening>& openings, const BeltConfig& belt,
              const DetectionTable& detection, const ThesisParameters& parameters);

  /// The best pose within `bounds`, which have a radius; of equals the one nearest to their centre.
  [[nodiscard]] Match match(const Scan& scan, const Bounds& bounds, MatchWorkspace& workspace) const;

  /// Offers the poses of a grid over the room, or over the bounds where they have a radius, to `modes`, which keeps the
  /// best of its capacity with no two alike.
  void search(const Scan& scan, const Bounds& bounds, const Grid& grid, RoomIndex room, std::vector<Mode>& modes,
              MatchWorkspace& workspace) const;

  /// Lowers a mode's objective on ever finer grids about it, the first half as wide as `grid`, within `bounds`; of the
  /// headings that match as well it takes the middle.
  void refine(const Scan& scan, const Bounds& bounds, const Grid& grid, Mode& mode, MatchWorkspace& workspace) const;

  [[nodiscard]] const RangeModel& model() const noexcept { return model_; }
  [[nodiscard]] const Floor& floor() const noexcept { return floor_; }

 private:
  /// Simulates the sensors of a belt at one pose; whether it is within the bounds and has readings enough to compare.
  bool score_pose(const Scan& scan, const Bounds& bounds, const Pose2& pose, double& objective,
                  MatchWorkspace& workspace) const;
  /// The better of the two goes into `mode`.
  void try_pose(const Scan& scan, const Bounds& bounds, const Pose2& pose, Mode& mode, MatchWorkspace& workspace) const;
  void centre_heading(const Scan& scan, const Bounds& bounds, double step, Mode& mode, MatchWorkspace& workspace) const;

  ThesisParameters parameters_;
  int least_matches_;
  Floor floor_;
  RangeModel model_;
};

/// Headings to one sensor's spacing so that they are about `spacing` (radians) apart.
[[nodiscard]] int sensor_step(int sensors, double spacing) noexcept;

/// Adds `mode` to `modes` (sorted, best first; never beyond its capacity) unless a better one stands next to it.
void offer_mode(const Mode& mode, std::vector<Mode>& modes);

}  // namespace echoway::thesis
