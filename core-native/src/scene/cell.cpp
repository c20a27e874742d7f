#include "scene/cell.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/visibility.hpp"

namespace echoway::scene {
namespace {

// One blocking piece that cuts off every corner of the box from both ends of the feet cuts off everything in between.
bool blocks_all(const Segment& s, const Box& box, const Segment& feet) noexcept {
  for (Vec2 c : box) {
    for (Vec2 f : {feet.a, feet.b}) {
      if (!blocks(s, c, in_front_of(f, c, distance(c, f)))) return false;
    }
  }
  return true;
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
  const double reference = std::atan2(middle.y - centre.y, middle.x - centre.x);
  double low = 0.0, high = 0.0;
  for (Vec2 corner : box) {
    for (Vec2 f : {goal.a, goal.b}) {
      const double off = wrap_angle(std::atan2(f.y - corner.y, f.x - corner.x) - reference);
      low = std::min(low, off);
      high = std::max(high, off);
    }
  }
  if (high - low > kPi) return {};
  return {reference + low, high - low};
}

// Sectors whose directions come within `reach` of those of the arc, as a bit mask.
std::uint32_t sectors_near(const Arc& arc, double reach) noexcept {
  constexpr double kWidth = kTwoPi / Cell::kSectors;
  constexpr double kSlack = 1e-9;
  const double half = 0.5 * (arc.width + kWidth) + reach + kSlack;
  if (half >= kPi) return ~std::uint32_t{0};
  const double middle = arc.begin + 0.5 * arc.width;
  const int first = static_cast<int>(std::ceil((middle - half) / kWidth - 0.5));
  const int last = static_cast<int>(std::floor((middle + half) / kWidth - 0.5));
  std::uint32_t mask = 0;
  for (int s = first; s <= last; ++s) mask |= std::uint32_t{1} << (static_cast<unsigned>(s) % Cell::kSectors);
  return mask;
}

struct Reach {
  std::uint32_t sharp = 0;   // Sectors from which the beam reaches an entry,
  std::uint32_t coarse = 0;  // and from which it does where headings are on a coarse grid.
};

Reach reach_of(const Reflector& r, const Candidate& c, const Box& box, const SightLimits& limits) noexcept {
  const Arc arc = directions(r, c, box);
  if (r.kind == ReflectorKind::all_reflective) {
    const std::uint32_t sectors = sectors_near(arc, limits.all_reflective_cut_off_rad);
    return {sectors, sectors};
  }
  const double rough = r.kind == ReflectorKind::wall && may_be_rough(c, limits) ? limits.rough_cut_off_rad : 0.0;
  return {sectors_near(arc, std::max(limits.sharp_cut_off_rad, rough)), sectors_near(arc, std::max(limits.cut_off_rad, rough))};
}

void fill_sectors(const RoomScene& room, const std::vector<Candidate>& seen, const Box& box, const SightLimits& limits, Cell& cell) {
  std::array<Reach, Cell::kMaxEntries> reaches;
  std::size_t count = 0;
  // Where there is no room for all, the farthest are left out of every sector, not everything of the last ones.
  for (std::size_t items = 0; count < seen.size(); ++count) {
    reaches[count] = reach_of(room.reflectors[seen[count].reflector], seen[count], box, limits);
    items += static_cast<std::size_t>(std::popcount(reaches[count].coarse));
    if (items > Cell::kMaxItems) break;
  }
  std::uint16_t used = 0;
  for (std::size_t s = 0; s < Cell::kSectors; ++s) {
    cell.sector_begin[s] = used;
    for (std::size_t i = 0; i < count; ++i) {
      if ((reaches[i].coarse >> s & 1U) == 0) continue;
      const bool sharp = (reaches[i].sharp >> s & 1U) != 0;
      cell.items[used++] = static_cast<std::uint8_t>(i | (sharp ? 0U : Cell::kCoarseOnly));
    }
  }
  cell.sector_begin[Cell::kSectors] = used;
}

}  // namespace

void compile_cell(const RoomScene& room, Vec2 low, Vec2 high, const SightLimits& limits, CellScratch& scratch,
                  Cell& cell) {
  const Box box = make_box(low, high);
  std::vector<Candidate>& seen = scratch.seen;
  std::vector<std::uint16_t>& between = scratch.between;
  seen.clear();
  for (std::size_t i = 0; i < room.reflectors.size(); ++i) {
    const Reflector& r = room.reflectors[i];
    Candidate c;
    if (!may_answer(room, i, box, limits, c)) continue;
    const auto through_door = [&] {
      const Opening& door = room.openings[static_cast<std::size_t>(r.opening)];
      return distance_to_box(door.centre, box) < kInDoorway ||
             ways_may_touch(box, c.feet, door.span());
    };
    if (r.opening >= 0 && !through_door()) continue;
    seen.push_back(c);
  }
  std::sort(seen.begin(), seen.end(), [](const Candidate& a, const Candidate& b) {
    return a.nearest != b.nearest ? a.nearest < b.nearest : a.reflector < b.reflector;
  });

  std::size_t kept = 0;
  std::uint16_t occluders_used = 0;
  for (const Candidate& c : seen) {
    if (kept == Cell::kMaxEntries) break;
    const Reflector& r = room.reflectors[c.reflector];
    between.clear();
    bool hidden = false;
    const bool mirrored = r.kind == ReflectorKind::mirrored_corner;
    Bounds reach;
    for (Vec2 p : {box[0], box[2], c.feet.a, c.feet.b}) reach.include(p);
    if (mirrored) reach.include(r.b);
    for (std::size_t k = 0; k < room.occluders.size() && !hidden; ++k) {
      if (static_cast<std::int16_t>(k) == r.own_index) continue;
      if (reach.misses(room.occluders[k])) continue;
      if (!ways_may_touch(box, c.feet, room.occluders[k]) &&
          !(mirrored && hull_may_touch<3>({c.feet.a, c.feet.b, r.b}, room.occluders[k]))) {
        continue;
      }
      between.push_back(static_cast<std::uint16_t>(k));
      hidden = !mirrored && r.kind != ReflectorKind::all_reflective && blocks_all(room.occluders[k], box, c.feet);
    }
    if (hidden || occluders_used + between.size() > Cell::kMaxOccluders) continue;
    cell.entries[kept] = {c.reflector, occluders_used, static_cast<std::uint16_t>(between.size())};
    for (std::uint16_t k : between) cell.occluders[occluders_used++] = k;
    seen[kept++] = c;
  }
  seen.resize(kept);
  cell.entry_count = static_cast<std::uint16_t>(kept);
  fill_sectors(room, seen, box, limits, cell);
  cell.plain_floor = room.floor.begin.size() > 1 && !room.floor.crossed_by_box(low, high) && room.floor.contains(0.5 * (low + high));
}

}  // namespace echoway::scene
