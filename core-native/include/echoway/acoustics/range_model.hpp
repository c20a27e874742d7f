#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "echoway/acoustics/detection.hpp"
#include "echoway/acoustics/element.hpp"
#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"

namespace echoway {

/// What one sensor would read.
struct PredictedEcho {
  double range_m = Firing::kNoEcho;  ///< From the transducer's face; kNoEcho when nothing answers.
  ElementKind kind = ElementKind::none;
  /// Index into the room's walls, corners, edges or reflectors. Jambs that the model added itself at a door's ends
  /// count on from the room's edges. -1 for `none`.
  std::int32_t index = -1;

  [[nodiscard]] bool has_echo() const noexcept { return kind != ElementKind::none; }
  friend constexpr bool operator==(const PredictedEcho&, const PredictedEcho&) = default;
};

/// A gap in a wall: an open door.
struct Opening {
  Vec2 at{};           ///< Its centre, in the room's frame, on a wall or nearly so.
  double width = 0.0;  ///< Metres.
};

/// The openings of one room, from the building's doors.
[[nodiscard]] std::vector<Opening> openings_of(const Building& building, RoomIndex room);

struct RangeModelParameters {
  /// A corner answers when its walls are at a right angle to within this; only then does it send sound straight back.
  double right_angle_tolerance_rad = degrees(4.0);
  /// How far an opening's centre may lie from the wall that it is cut into, metres.
  double opening_reach_m = 0.3;
  /// A jamb is added at an opening's end unless the room has an edge within this distance of it, metres.
  double jamb_spacing_m = 0.15;
};

/// `count` directions spread evenly over a full turn, the first of them `first` (radians, room's frame).
class Directions {
 public:
  Directions() = default;
  Directions(double first, int count) { reset(first, count); }
  /// No allocation once a larger count has been seen.
  void reset(double first, int count);

  [[nodiscard]] int count() const noexcept { return static_cast<int>(unit_.size()); }
  [[nodiscard]] double first() const noexcept { return first_; }
  [[nodiscard]] double step() const noexcept { return step_; }
  [[nodiscard]] Vec2 unit(int k) const noexcept { return unit_[static_cast<std::size_t>(k)]; }

 private:
  double first_ = 0.0;
  double step_ = 0.0;
  std::vector<Vec2> unit_;
};

/// Which echo each sensor of a belt would receive at any pose in one room: the fast stand-in for the waveform model
/// that the matching uses (thesis section 4.2, Kuc and Siegel 1987).
///
/// A sensor at face f, `radius` ahead of the wearer's axis in its direction u, hears
/// - a wall when the perpendicular from f falls on it, within the detection half-angle of u;
/// - a right-angled corner that it is inside of, and an edge, each within the half-angle for its kind and distance;
/// - an all-reflective element at its nearest visible point within the beam, at any incidence;
/// each unless a wall or an all-reflective element stands between, and only from `min_range` to `max_range`. The
/// nearest answers; on a tie the one listed first above. Open doors neither answer nor block, their jambs are edges;
/// what lies beyond them is not seen.
///
/// Positions are taken to be inside the room. Elsewhere the answer is finite and harmless, but the room's outermost
/// walls do not block. Immutable once built: any number of threads may share one.
class RangeModel {
 public:
  RangeModel(const Room& room, std::span<const Opening> openings, const BeltConfig& belt,
             const DetectionTable& detection, const RangeModelParameters& parameters = {});

  /// What `sensor` of the belt reads when the wearer stands at `pose` (room's frame).
  [[nodiscard]] PredictedEcho predict(const Pose2& pose, int sensor) const noexcept;
  /// What a sensor reads that points along `unit` from a wearer whose axis is at `axis`.
  [[nodiscard]] PredictedEcho predict_towards(Vec2 axis, Vec2 unit) const noexcept;

  /// What the sensors of a belt `radius` out read in every one of `directions`, at once: what depends on the position
  /// alone is worked out once, and a belt at any heading of that grid only looks its readings up. The same answers as
  /// predict_towards(). `out` holds directions.count() entries.
  void sweep(Vec2 axis, const Directions& directions, std::span<PredictedEcho> out) const noexcept;

  [[nodiscard]] const BeltConfig& belt() const noexcept { return belt_; }
  /// The greatest distance between any two points of the room's elements, metres; at most the belt's maximum range.
  [[nodiscard]] double greatest_range() const noexcept { return greatest_range_; }
  [[nodiscard]] std::size_t element_count() const noexcept {
    return walls_.size() + corners_.size() + edges_.size() + reflectors_.size();
  }

 private:
  struct Wall {
    Vec2 a{};
    Vec2 along{};            ///< Unit.
    Vec2 normal{};           ///< Unit, to the left of `along`.
    double length = 0.0;
    double normal_angle = 0.0;
    std::int32_t index = -1;
  };
  struct Corner {
    Vec2 at{};
    Vec2 arm_a{};            ///< Unit, along the walls; both zero when no walls were found there.
    Vec2 arm_b{};
    std::int32_t index = -1;
  };
  struct Edge {
    Vec2 at{};
    std::int32_t index = -1;
  };
  struct Reflector {
    Segment segment{};
    Vec2 outward{};          ///< Unit, for a side of a closed outline (a bench), seen from outside only; else zero.
    std::int32_t index = -1;
  };
  /// One sensor's ray.
  struct Ray {
    Vec2 axis{};
    Vec2 face{};
    Vec2 unit{};
  };
  enum class Sight : std::uint8_t { clear, blocked, depends };

  void add_walls(const Room& room, std::span<const Opening> openings, const RangeModelParameters& parameters);
  void add_corners(const Room& room, double tolerance);
  void add_reflectors(const Room& room);
  void add_occluders();

  [[nodiscard]] Ray ray(Vec2 axis, Vec2 unit) const noexcept;
  [[nodiscard]] bool in_range(double z) const noexcept { return z >= belt_.min_range_m && z <= belt_.max_range_m; }
  [[nodiscard]] bool blocked(Vec2 from, Vec2 to) const noexcept;
  [[nodiscard]] bool hidden(const Ray& ray, Vec2 target) const noexcept;
  [[nodiscard]] Sight sight(Vec2 axis, Vec2 target, bool converging) const noexcept;

  [[nodiscard]] Sight sight_along(Vec2 axis, const Segment& target) const noexcept;

  // Each offers its echo to `best`, which keeps the nearest.
  void offer_wall(const Wall& wall, const Ray& ray, Sight sight, PredictedEcho& best) const noexcept;
  void offer_corner(const Corner& corner, const Ray& ray, Sight sight, PredictedEcho& best) const noexcept;
  void offer_edge(const Edge& edge, const Ray& ray, Sight sight, PredictedEcho& best) const noexcept;
  void offer_point(Vec2 at, ElementKind kind, std::int32_t index, const Ray& ray, Sight sight,
                   PredictedEcho& best) const noexcept;
  void offer_reflector(const Reflector& reflector, const Ray& ray, Sight sight, PredictedEcho& best) const noexcept;

  void sweep_reflectors(Vec2 axis, const Directions& directions, double reach,
                        std::span<PredictedEcho> out) const noexcept;
  template <class Offer>
  void for_directions(const Directions& directions, double bearing, double half_width, std::span<PredictedEcho> out,
                      Vec2 axis, Offer offer) const noexcept;

  BeltConfig belt_;
  DetectionTable detection_;
  double sin_widest_ = 0.0;       ///< Of the widest half-angle.
  double cos_widest_ = 1.0;
  double edge_reach_ = 0.0;       ///< Beyond it no edge answers, metres.
  double lateral_ = 0.0;          ///< How far to the side of the axis a face in reach of a bearing may be, metres.
  double greatest_range_ = 0.0;
  std::vector<Wall> walls_;
  std::vector<Corner> corners_;
  std::vector<Edge> edges_;
  std::vector<Reflector> reflectors_;
  std::vector<Segment> occluders_;
};

}  // namespace echoway
