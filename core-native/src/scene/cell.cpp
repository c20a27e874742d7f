#include "scene/cell.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "scene/visibility.hpp"

namespace echoway::scene {
namespace {

// Occluders that are ruled out together: walls that follow each other in a plan stand side by side.
constexpr std::size_t kTogether = 8;
// Numbers of occluders that the lists of a cell's entries may take, apart from one of all.
constexpr std::size_t kMaxListed = 8192;

// One blocking piece that cuts off every corner of the box from both ends of the feet cuts off everything in between.
bool blocks_all(const Segment& s, const Box& box, const Segment& feet) noexcept {
  for (Vec2 c : box) {
    for (Vec2 f : {feet.a, feet.b}) {
      if (!blocks(s, c, in_front_of(f, c, distance(c, f)))) return false;
    }
  }
  return true;
}

// Where the way from a wall to a corner that it mirrors may lead: it begins kSightClearance before the wall.
Hull ways_from_mirror(const Segment& feet, const Reflector& corner) noexcept {
  const Vec2 before = kSightClearance / distance(corner.a, corner.b) * (corner.b - corner.a);
  const Vec2 aside =
      dot(feet.direction(), perpendicular(before)) < 0.0 ? -perpendicular(before) : perpendicular(before);
  const Vec2 begin = feet.a - aside;
  return {begin, feet.b + aside, begin + before, corner.b};
}

// Directions from the box to the feet, as [begin, begin + width).
struct Arc {
  double begin = 0.0;
  double width = kTwoPi;
};

Arc directions(const Reflector& r, const Candidate& c, const Box& box) noexcept {
  if (r.kind == ReflectorKind::wall && !r.two_sided) return {std::atan2(-r.normal.y, -r.normal.x), 0.0};
  if (c.nearest < 1e-3) return {};
  const Vec2 centre = 0.5 * (box[0] + box[2]);
  const Segment goal = r.kind == ReflectorKind::mirrored_corner ? Segment{r.a, r.a} : c.feet;
  const Vec2 middle = 0.5 * (goal.a + goal.b);
  const Vec2 reference = middle - centre;
  // The outermost on either side, told without angles: all are within a right angle of the reference, or the sound may
  // come from anywhere.
  Vec2 right{1.0, 0.0}, left{1.0, 0.0};   // Along the reference and aside.
  for (Vec2 corner : box) {
    for (Vec2 f : {goal.a, goal.b}) {
      const Vec2 way{dot(reference, f - corner), cross(reference, f - corner)};
      if (!(way.x > 0.0)) return {};
      if (cross(right, way) < 0.0) right = way;
      if (cross(left, way) > 0.0) left = way;
    }
  }
  const double low = std::atan2(right.y, right.x);
  const double high = std::atan2(left.y, left.x);
  return {std::atan2(reference.y, reference.x) + low, high - low};
}

// Sectors whose directions come within `reach` of those of the arc, as a bit mask.
std::uint32_t sectors_near(const Arc& arc, double reach) noexcept {
  constexpr double kWidth = kTwoPi / Cell::kSectors;
  constexpr double kSlack = 1e-9;
  static_assert(Cell::kSectors == 32, "one for each bit of the mask");
  const double half = 0.5 * (arc.width + kWidth) + reach + kSlack;
  if (half >= kPi) return ~std::uint32_t{0};
  const double middle = arc.begin + 0.5 * arc.width;
  const int first = static_cast<int>(std::ceil((middle - half) / kWidth - 0.5));
  const int last = static_cast<int>(std::floor((middle + half) / kWidth - 0.5));
  std::uint32_t mask = 0;
  for (int s = first; s <= last; ++s) mask |= std::uint32_t{1} << (static_cast<unsigned>(s) % Cell::kSectors);
  return mask;
}

}  // namespace

CellScratch::CellScratch(std::size_t reflectors, std::size_t occluders) {
  bounds_.reserve(occluders / kTogether + 1);
  reaches_.reserve(reflectors);
  between_.reserve(occluders);
  entries_.reserve(reflectors);
  items_.reserve(reflectors * Cell::kSectors);
  occluders_.reserve(kMaxListed + occluders);
}

std::size_t CellScratch::largest_cell() const noexcept {
  return entries_.capacity() * sizeof(Cell::Entry) +
         (items_.capacity() + occluders_.capacity()) * sizeof(std::uint16_t);
}

std::size_t CellScratch::memory() const noexcept {
  return largest_cell() + bounds_.capacity() * sizeof(Bounds) + reaches_.capacity() * sizeof(Reach) +
         between_.capacity() * sizeof(std::uint16_t);
}

class CellCompiler {
 public:
  CellCompiler(const RoomScene& room, const Box& box, const SightLimits& limits, CellScratch& scratch) noexcept
      : room_(room), box_(box), limits_(limits), scratch_(scratch) {}

  Cell compile() noexcept {
    Cell cell;
    bound_occluders();
    list_entries();
    list_sectors(cell);
    cell.entries = scratch_.entries_;
    cell.items = scratch_.items_;
    cell.occluders = scratch_.occluders_;
    return cell;
  }

 private:
  void bound_occluders() noexcept {
    scratch_.bounds_.assign((room_.occluders.size() + kTogether - 1) / kTogether, {});
    for (std::size_t k = 0; k < room_.occluders.size(); ++k) {
      Bounds& bounds = scratch_.bounds_[k / kTogether];
      bounds.include(room_.occluders[k].a);
      bounds.include(room_.occluders[k].b);
    }
  }

  bool shows_through_its_door(const Candidate& c, const Hull& ways) const noexcept {
    const Reflector& r = room_.reflectors[c.reflector];
    if (r.opening < 0) return true;
    const Opening& door = room_.openings[static_cast<std::size_t>(r.opening)];
    return distance_to_box(door.centre, box_) < kInDoorway || ways.may_touch(door.span());
  }

  void list_entries() noexcept {
    scratch_.entries_.clear();
    scratch_.reaches_.clear();
    scratch_.occluders_.clear();
    for (std::size_t i = 0; i < room_.reflectors.size(); ++i) {
      Candidate c;
      if (!may_answer(room_, i, box_, limits_, c)) continue;
      const Hull ways(box_, c.feet);
      if (!shows_through_its_door(c, ways) || !find_between(c, ways)) continue;
      scratch_.entries_.push_back(entry_of(c));
      scratch_.reaches_.push_back(reach_of(c));
    }
  }

  // Lists what may stand between the box and `c`. False when that hides it from all of the box.
  bool find_between(const Candidate& c, const Hull& ways) noexcept {
    const Reflector& r = room_.reflectors[c.reflector];
    const bool mirrored = r.kind == ReflectorKind::mirrored_corner;
    const bool hideable = r.kind != ReflectorKind::all_reflective;
    Bounds reach = ways.bounds();
    std::optional<Hull> from_mirror;
    if (mirrored) {
      reach.include(r.b);
      from_mirror = ways_from_mirror(c.feet, r);
    }
    const auto in_the_way = [&](const Segment& s) {
      if (!from_mirror) return ways.may_touch(s);
      return !reach.misses(s) && (ways.may_touch(s) || from_mirror->may_touch(s));
    };
    scratch_.between_.clear();
    for (std::size_t begin = 0; begin < room_.occluders.size(); begin += kTogether) {
      if (reach.misses(scratch_.bounds_[begin / kTogether])) continue;
      const std::size_t end = std::min(begin + kTogether, room_.occluders.size());
      for (std::size_t k = begin; k < end; ++k) {
        const Segment& s = room_.occluders[k];
        if (static_cast<std::int16_t>(k) == r.own_index || !in_the_way(s)) continue;
        if (hideable && blocks_all(s, box_, c.feet)) return false;
        scratch_.between_.push_back(static_cast<std::uint16_t>(k));
      }
    }
    return true;
  }

  // Where there is no place for another list, sight is tested against all that the room holds.
  Cell::Entry entry_of(const Candidate& c) noexcept {
    std::vector<std::uint16_t>& between = scratch_.between_;
    std::vector<std::uint16_t>& listed = scratch_.occluders_;
    const auto begin = static_cast<std::uint16_t>(listed.size());
    if (listed.size() + between.size() <= kMaxListed) {
      listed.insert(listed.end(), between.begin(), between.end());
      return {c.reflector, begin, static_cast<std::uint16_t>(between.size())};
    }
    const std::size_t all = room_.occluders.size();
    if (!all_begin_) {
      all_begin_ = begin;
      listed.resize(listed.size() + all);
      std::iota(listed.begin() + begin, listed.end(), std::uint16_t{0});
    }
    return {c.reflector, *all_begin_, static_cast<std::uint16_t>(all)};
  }

  CellScratch::Reach reach_of(const Candidate& c) const noexcept {
    const Reflector& r = room_.reflectors[c.reflector];
    const Arc arc = directions(r, c, box_);
    if (r.kind == ReflectorKind::all_reflective) {
      const std::uint32_t sectors = sectors_near(arc, limits_.all_reflective_cut_off_rad);
      return {sectors, sectors};
    }
    const double rough = r.kind == ReflectorKind::wall && may_be_rough(c, limits_) ? limits_.rough_cut_off_rad : 0.0;
    return {sectors_near(arc, std::max(limits_.sharp_cut_off_rad, rough)),
            sectors_near(arc, std::max(limits_.cut_off_rad, rough))};
  }

  // Entries keep their order within each sector.
  void list_sectors(Cell& cell) noexcept {
    std::array<std::uint32_t, Cell::kSectors + 1>& begin = cell.sector_begin;
    for (const CellScratch::Reach& reach : scratch_.reaches_) {
      for (std::uint32_t left = reach.coarse; left != 0; left &= left - 1) ++begin[std::countr_zero(left) + 1U];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint16_t>& items = scratch_.items_;
    items.resize(begin.back());
    std::array<std::uint32_t, Cell::kSectors + 1> next = begin;
    for (std::size_t i = 0; i < scratch_.reaches_.size(); ++i) {
      const CellScratch::Reach& reach = scratch_.reaches_[i];
      for (std::uint32_t left = reach.coarse; left != 0; left &= left - 1) {
        const auto s = static_cast<std::size_t>(std::countr_zero(left));
        const bool sharp = (reach.sharp >> s & 1U) != 0;
        items[next[s]++] = static_cast<std::uint16_t>(i | (sharp ? 0U : Cell::kCoarseOnly));
      }
    }
  }

  const RoomScene& room_;
  const Box& box_;
  const SightLimits& limits_;
  CellScratch& scratch_;
  std::optional<std::uint16_t> all_begin_;   // Where all the occluders are listed.
};

Cell compile_cell(const RoomScene& room, Vec2 low, Vec2 high, const SightLimits& limits,
                  CellScratch& scratch) noexcept {
  const Box box = make_box(low, high);
  Cell cell = CellCompiler(room, box, limits, scratch).compile();
  cell.plain_floor =
      room.floor.begin.size() > 1 && !room.floor.crossed_by_box(low, high) && room.floor.contains(0.5 * (low + high));
  return cell;
}

}  // namespace echoway::scene
