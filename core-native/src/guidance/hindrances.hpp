#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "echoway/guidance/guide_config.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/route_line.hpp"

namespace echoway::guidance {

/// Things in the way that no plan knows, remembered for a while as discs, and the way round them.
class Hindrances {
 public:
  explicit Hindrances(const GuideConfig& config);

  /// Something stands at `at`, seen or touched at `time_s`. What is close to a known thing renews it.
  void add(RoomIndex room, Vec2 at, double time_s) noexcept;
  void clear() noexcept { size_ = 0; }

  /// How far it is from `from` along `unit` to the first of them, at most `limit`.
  [[nodiscard]] double reach(RoomIndex room, double time_s, Vec2 from, Vec2 unit, double limit) const noexcept;

  /// Leads the stretch of `line` that lies in `room`, where it begins, round what stands on it. The line stays as it is
  /// where nothing does or no way round is found.
  void bend(const FreeSpace& space, RoomIndex room, double time_s, std::vector<LinePoint>& line);
  /// True when something that the last line was bent round stands on this way.
  [[nodiscard]] bool hinders(const Segment& way) const noexcept { return stands_on(way, kept_m_); }

 private:
  struct Disc {
    RoomIndex room = kNoRoom;
    Vec2 at{};
    double seen_s = -1e300;
  };
  static constexpr std::size_t kMost = 12;
  static constexpr std::size_t kRing = 12;  ///< Corners of the polygon about a disc.

  [[nodiscard]] bool counts(const Disc& disc, RoomIndex room, double time_s) const noexcept;
  [[nodiscard]] bool stands_on(const Segment& way, double radius) const noexcept;
  [[nodiscard]] bool lead_round(const FreeSpace& space, double radius, std::size_t last, std::vector<LinePoint>& line);

  const GuideConfig* config_;
  std::array<Disc, kMost> discs_{};
  std::size_t size_ = 0;
  // Of the search for a way round; kept for their memory.
  std::vector<Vec2> near_;        ///< Discs that count here,
  double kept_m_ = 0.0;           ///< and how far the line keeps from them.
  std::vector<Vec2> nodes_;
  std::vector<double> costs_;
  std::vector<std::size_t> before_;
  std::vector<bool> done_;
  std::vector<LinePoint> bent_;
};

}  // namespace echoway::guidance
