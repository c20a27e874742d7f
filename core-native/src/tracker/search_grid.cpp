#include "tracker/search_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tracker/floor.hpp"

namespace echoway::tracker {
namespace {

constexpr int kBlock = 4;             // Places along each side of a block.
constexpr double kRounding = 1e-6;    // Metres.

// Whether any of a room lies within the domain, by its bounding box. The next levels above and below count as near:
// somebody may have taken the stairs unnoticed.
bool reaches(const SearchDomain& domain, RoomIndex index, const SearchTools& tools) noexcept {
  if (!domain.within) return true;
  const auto& room = tools.scene.room(index);
  const Room& here = tools.building.room(index);
  const Room& near = tools.building.room(domain.near_room);
  if (std::abs(here.level - near.level) > 1) return false;
  const Vec2 centre = here.frame.inverse_transform(near.frame.transform(domain.near_position));
  const Vec2 closest{std::clamp(centre.x, room.low.x, room.high.x), std::clamp(centre.y, room.low.y, room.high.y)};
  return distance(centre, closest) <= *domain.within;
}

bool worth_trying(const SearchDomain& domain, RoomIndex room, Vec2 position, const SearchTools& tools) noexcept {
  if (domain.within) {
    const Vec2 about = tools.building.room(domain.near_room).frame.transform(domain.near_position);
    if (distance(tools.building.room(room).frame.transform(position), about) > *domain.within) return false;
  }
  return can_stand(tools.scene.room(room), position);
}

}  // namespace

void SearchGrid::start(const SearchDomain& domain) noexcept {
  room_ = domain.only_room == kNoRoom ? 0 : domain.only_room;
  entered_ = false;
}

bool SearchGrid::next(const SearchTools& tools, const SearchDomain& domain) noexcept {
  const auto rooms = static_cast<RoomIndex>(tools.scene.room_count());
  for (; room_ < rooms; ++room_, entered_ = false) {
    if (entered_) {
      step();
    } else {
      enter_room(tools, domain);
    }
    for (; row_ < rows_; step()) {
      if (worth_trying(domain, room_, position(), tools)) return true;
    }
    if (domain.only_room != kNoRoom) return false;
  }
  return false;
}

void SearchGrid::enter_room(const SearchTools& tools, const SearchDomain& domain) noexcept {
  const auto& room = tools.scene.room(room_);
  const Vec2 size = room.high - room.low;
  columns_ = std::max(1, static_cast<int>(std::ceil(size.x / spacing_)));
  rows_ = reaches(domain, room_, tools) ? std::max(1, static_cast<int>(std::ceil(size.y / spacing_))) : 0;
  origin_ = room.low + 0.5 * Vec2{size.x - spacing_ * (columns_ - 1), size.y - spacing_ * (rows_ - 1)};
  column_ = row_ = block_column_ = block_row_ = 0;
  seen_.reset();
  entered_ = true;
}

void SearchGrid::step() noexcept {
  if (++column_ < std::min(block_column_ + kBlock, columns_)) return;
  column_ = block_column_;
  if (++row_ < std::min(block_row_ + kBlock, rows_)) return;
  seen_.reset();
  block_column_ += kBlock;
  if (block_column_ >= columns_) {
    block_column_ = 0;
    block_row_ += kBlock;
  }
  column_ = block_column_;
  row_ = block_row_;
}

const scene::Cell& SearchGrid::seen(const SearchTools& tools) noexcept {
  if (seen_) return *seen_;
  const Vec2 beside = (tools.belt.radius_m + kRounding) * Vec2{1.0, 1.0};
  const int last_column = std::min(block_column_ + kBlock, columns_) - 1;
  const int last_row = std::min(block_row_ + kBlock, rows_) - 1;
  const Vec2 low = origin_ + spacing_ * Vec2{1.0 * block_column_, 1.0 * block_row_};
  const Vec2 high = origin_ + spacing_ * Vec2{1.0 * last_column, 1.0 * last_row};
  return seen_.emplace(tools.scene.seen_from(room_, low - beside, high + beside));
}

}  // namespace echoway::tracker
