#pragma once

#include <array>

#include "tracker/likelihood.hpp"

namespace echoway::tracker {

/// What a firing may return from one place, by the direction fired. A search tries many headings at a place and replays
/// many firings at each; what can be seen in a direction is worked out once for all of them.
class Panorama {
 public:
  static constexpr int kDirections = 30;   ///< 12 degrees apart, as the headings tried, and half of what sensors are.

  /// Looks from `position` in `room`, which must outlive it, from now on; nothing is worked out yet.
  void stand_at(const scene::RoomScene& room, Vec2 position) noexcept;

  struct Sight {
    ExpectedEchoes echoes;
    double silence = 1.0;                  ///< Probability that none of them answers.
  };
  /// What can be seen in the direction of `angle` (radians, room frame) from a transducer `radius` off the place.
  /// `seen` lists what can be seen from where the transducer is.
  [[nodiscard]] const Sight& towards(double angle, double radius, const EchoModel& model,
                                     const scene::Cell& seen) noexcept;

  /// Directions worked out so far, over all places.
  [[nodiscard]] std::size_t looks() const noexcept { return looks_; }

 private:
  const scene::RoomScene* room_ = nullptr;
  Vec2 position_{};
  std::array<Sight, kDirections> sights_;
  std::array<bool, kDirections> known_{};
  std::size_t looks_ = 0;
};

/// Where a wearer is who stood at the panorama's place a little earlier, and how uncertain that is.
struct Offset {
  Vec2 moved{};                   ///< Metres, room frame: correct to first order in what the panorama shows.
  Vec2 per_speed{};               ///< Seconds, room frame: what a faster pace would add.
  double speed_variance = 0.0;    ///< (m/s)^2.
  double variance = 0.0;          ///< Metres^2 either way: size of the cell that the place stands for, sway.
  double log_scale = 0.0;         ///< ln(measured range / true range),
  double log_scale_variance = 0.0;
};

/// Density of a reading as in weigh(), per metre for an echo and a plain probability for none.
[[nodiscard]] double density_of(const Panorama::Sight& sight, bool echo, double range, const Offset& offset,
                                const EchoModel& model) noexcept;

}  // namespace echoway::tracker
