#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "echoway/guidance/guide_config.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/detour.hpp"
#include "guidance/route_line.hpp"

namespace echoway::guidance {

/// Things in the way that no plan knows: points of them that were heard or touched, remembered for a while, and the way
/// round them.
class Hindrances {
 public:
  explicit Hindrances(const GuideConfig& config);

  /// An echo of something came from `at` at `time_s`. What is close to a known point renews it.
  void hear(RoomIndex room, Vec2 at, double time_s) noexcept { add({room, at, time_s, 0}); }
  /// The wearer, who stands at `pose`, has met something `ahead` metres before their middle.
  void touch(RoomIndex room, const Pose2& pose, double ahead, double time_s) noexcept;
  /// The wearer, who stands at `pose`, hears something `ahead` metres before their middle: as sure as if they had met
  /// it, but they have not been stopped once more.
  void stand_before(RoomIndex room, const Pose2& pose, double ahead, double time_s) noexcept;
  void clear() noexcept;

  /// How far it is from `from` along `unit` to the first of them, at most `limit`.
  [[nodiscard]] double reach(RoomIndex room, double time_s, Vec2 from, Vec2 unit, double limit) const noexcept;

  /// Leads the stretch of `line` that lies in `room`, where it begins, round what stands near it. A way that was found
  /// is kept as long as it is little worse than the best one: who is sent to and fro gets nowhere. The line stays as it
  /// is where nothing stands or walls leave no other way.
  void bend(const FreeSpace& space, RoomIndex room, double time_s, std::vector<LinePoint>& line);
  /// True when something that the last line was bent round stands on this way.
  [[nodiscard]] bool hinders(const Segment& way) const noexcept { return stands_on(way, kept_m_); }

 private:
  struct Point {
    RoomIndex room = kNoRoom;
    Vec2 at{};
    double seen_s = -1e300;
    int met = 0;  ///< How often the wearer was stopped about here; 0: only heard.
  };
  static constexpr std::size_t kMost = 128;

  void add(const Point& point) noexcept;
  /// As broad to either side of `forward` as what stops a chest.
  void add_broad(RoomIndex room, Vec2 at, Vec2 forward, double time_s, int met) noexcept;
  void forget_way() noexcept { kept_.clear(); }
  [[nodiscard]] int times_met(RoomIndex room, Vec2 at, double time_s) const noexcept;
  [[nodiscard]] static bool counts(const Point& point, RoomIndex room, double time_s) noexcept;
  [[nodiscard]] bool stands_on(const Segment& way, double radius) const noexcept;
  [[nodiscard]] bool stands_near(std::span<const LinePoint> line, std::size_t last) const noexcept;
  void look_round(RoomIndex room, double time_s, Vec2 from);
  [[nodiscard]] bool still_good(Vec2 from, Vec2 to);
  [[nodiscard]] bool is_taken(Vec2 at) const;
  [[nodiscard]] Vec2 part_of_the_way(Vec2 from, const Segment& leg) const;
  [[nodiscard]] double nearest_to_way() const;

  const GuideConfig* config_;
  std::array<Point, kMost> points_{};
  std::size_t size_ = 0;
  Detour detour_;
  RoomIndex room_ = kNoRoom;      ///< Of the way that was found last.
  std::vector<Vec2> kept_;        ///< That way, from where the wearer is now.
  std::vector<Vec2> found_;
  std::vector<ThingPoint> near_;  ///< Points that count here,
  double kept_m_ = 0.0;           ///< and how far the line keeps from them.
  std::vector<LinePoint> bent_;
};

}  // namespace echoway::guidance
