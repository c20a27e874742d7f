#pragma once

#include <optional>

#include "tracker/search_domain.hpp"
#include "tracker/search_tools.hpp"

namespace echoway::tracker {

/// The places of a search's domain where somebody can stand: a square grid in each room, block by block, so that what
/// can be seen from places close together is worked out once for all of them.
class SearchGrid {
 public:
  /// `spacing`: metres between places.
  explicit SearchGrid(double spacing) noexcept : spacing_(spacing) {}

  /// Begins anew, before the domain's first place.
  void start(const SearchDomain& domain) noexcept;
  /// Goes on to the next place. False when there is none left.
  [[nodiscard]] bool next(const SearchTools& tools, const SearchDomain& domain) noexcept;

  [[nodiscard]] double spacing() const noexcept { return spacing_; }
  [[nodiscard]] RoomIndex room() const noexcept { return room_; }
  /// In the room's frame.
  [[nodiscard]] Vec2 position() const noexcept { return origin_ + spacing_ * Vec2{1.0 * column_, 1.0 * row_}; }

  /// What can be seen by a belt at the place. Holds until the next place, or until anybody else compiles a cell; before
  /// it is asked for again after that, it must be forgotten.
  [[nodiscard]] const scene::Cell& seen(const SearchTools& tools) noexcept;
  void forget_seen() noexcept { seen_.reset(); }

 private:
  void enter_room(const SearchTools& tools, const SearchDomain& domain) noexcept;
  void step() noexcept;

  double spacing_;
  RoomIndex room_ = 0;
  bool entered_ = false;                    ///< Whether the following are about that room.
  Vec2 origin_{};
  int columns_ = 0, rows_ = 0;
  int column_ = 0, row_ = 0;
  int block_column_ = 0, block_row_ = 0;    ///< First place of the block,
  std::optional<scene::Cell> seen_;         ///< and what can be seen from there.
};

}  // namespace echoway::tracker
