#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "scene/room_scene.hpp"
#include "tracker/likelihood.hpp"

namespace echoway::test {

/// A room of which nothing is left out: every reflector in every direction, with everything that blocks sight in
/// between.
class WholeRoom {
 public:
  explicit WholeRoom(scene::RoomScene room) : room_(std::move(room)), items_(room_.reflectors.size()) {
    const auto all = static_cast<std::uint16_t>(room_.occluders.size());
    for (int twice = 0; twice < 2; ++twice) {
      for (std::uint16_t k = 0; k < all; ++k) occluders_.push_back(k);
    }
    std::iota(items_.begin(), items_.end(), std::uint16_t{0});
    for (const std::uint16_t i : items_) {
      const int own = room_.reflectors[i].own_index;   // All but what cannot hide itself, beginning after it.
      if (own < 0) {
        entries_.push_back({i, 0, all});
      } else {
        entries_.push_back({i, static_cast<std::uint16_t>(own + 1), static_cast<std::uint16_t>(all - 1)});
      }
    }
    for (std::size_t s = 0; s < cells_.size(); ++s) cells_[s] = list_in(s);
  }
  WholeRoom(const WholeRoom&) = delete;   // Its cells point into its lists.
  WholeRoom& operator=(const WholeRoom&) = delete;

  [[nodiscard]] tracker::ExpectedEchoes expect(const tracker::Particle& p, const tracker::Shot& shot,
                                               const tracker::EchoModel& model) const noexcept {
    const double turns = (p.heading + shot.bearing_rad) / kTwoPi;
    const double part = turns - std::floor(turns);
    const auto sector = std::min(static_cast<std::size_t>(part * scene::Cell::kSectors), cells_.size() - 1);
    return tracker::expect_from(cells_[sector], room_, p, shot, model);
  }

 private:
  // All of it stands in the sector from which a firing is asked for.
  [[nodiscard]] scene::Cell list_in(std::size_t sector) const {
    scene::Cell cell;
    cell.entries = entries_;
    cell.items = items_;
    cell.occluders = occluders_;
    for (std::size_t s = sector + 1; s <= scene::Cell::kSectors; ++s) {
      cell.sector_begin[s] = static_cast<std::uint32_t>(items_.size());
    }
    return cell;
  }

  scene::RoomScene room_;
  std::vector<std::uint16_t> occluders_;
  std::vector<std::uint16_t> items_;
  std::vector<scene::Cell::Entry> entries_;
  std::array<scene::Cell, scene::Cell::kSectors> cells_;
};

}  // namespace echoway::test
