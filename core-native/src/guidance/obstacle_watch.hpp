#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "echoway/belt/belt.hpp"
#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// Watches for steady echoes of things that are in no plan, all round the wearer.
class ObstacleWatch {
 public:
  ObstacleWatch(const Router& router, const GuideConfig& config) : router_(&router), config_(&config) {}

  /// Takes a firing in, at the pose that `estimate` gives for it.
  void on_firing(const Firing& firing, const Estimate& estimate) noexcept;
  void clear() noexcept { count_ = 0; }

  /// Calls `take(Vec2 at)` for everything near that enough firings agree on, in the frame of the estimate's room.
  template <class Take>
  void steady(const Estimate& estimate, Take take) const {
    const std::size_t kept = std::min(count_, kHits);
    for (std::size_t i = 0; i < kept; ++i) {
      if (is_steady(hits_[i], estimate)) take(hits_[i].at);
    }
  }

  struct Sighting {
    bool present = false;
    double distance_m = 0.0;  ///< From the wearer's chest.
    double direction = 0.0;   ///< From the chest, radians.
  };
  /// The nearest thing ahead within `reach` that enough firings agree on.
  [[nodiscard]] Sighting nearest(const Estimate& estimate, double reach) const noexcept;

 private:
  struct Hit {
    double time_s = 0.0;
    RoomIndex room = kNoRoom;
    Vec2 at{};
  };
  static constexpr std::size_t kHits = 64;  // of a belt in its memory
  [[nodiscard]] bool is_steady(const Hit& hit, const Estimate& estimate) const noexcept;

  const Router* router_;
  const GuideConfig* config_;
  std::array<Hit, kHits> hits_{};
  std::size_t count_ = 0;  ///< Ever; hits_[count_ % kHits] is the oldest.
};

}  // namespace echoway::guidance
