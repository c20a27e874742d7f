#include "scene/cell.hpp"

#include <algorithm>
#include <cmath>

#include "scene/visibility.hpp"

namespace echoway::scene {
namespace {

using Corners = std::array<Vec2, 4>;

double distance_to_box(Vec2 p, const Corners& box) noexcept {
  const double dx = std::max({box[0].x - p.x, 0.0, p.x - box[2].x});
  const double dy = std::max({box[0].y - p.y, 0.0, p.y - box[2].y});
  return hypotenuse(dx, dy);
}

bool may_be_rough(const Candidate& wall, const SightLimits& limits) noexcept { return wall.nearest < limits.rough_range; }

bool wall_candidate(const Reflector& r, const Corners& box, const SightLimits& limits, Candidate& out) noexcept {
  double low = 1e300, high = -1e300, near_side = 1e300, far_side = -1e300;
  for (Vec2 c : box) {
    const double t = r.along(c);
    const double d = r.signed_distance(c);
    low = std::min(low, t);
    high = std::max(high, t);
    near_side = std::min(near_side, d);
    far_side = std::max(far_side, d);
  }
  if (!r.two_sided && far_side <= 0.0) return false;
  if (near_side * far_side < 0.0) near_side = 0.0;
  out.nearest = std::min(std::abs(near_side), std::abs(far_side));
  if (may_be_rough(out, limits)) {
    const double aside = std::sin(limits.rough_cut_off_rad) * limits.rough_range;
    low -= aside;
    high += aside;
  }
  if (high < 0.0 || low > r.length) return false;
  out.feet = {r.a + std::max(low, 0.0) * r.tangent, r.a + std::min(high, r.length) * r.tangent};
  return out.nearest <= limits.max_range;
}

// The stretch of the mirroring wall in which an image can be seen from the box.
bool mirrored_candidate(const RoomScene& room, const Reflector& r, const Corners& box, const SightLimits& limits,
                        Candidate& out) noexcept {
  const Reflector& wall = room.reflectors[static_cast<std::size_t>(r.mirror)];
  const double behind = wall.signed_distance(r.a);
  double low = 1e300, high = -1e300;
  for (Vec2 c : box) {
    const double before = wall.signed_distance(c);
    if (before * behind >= 0.0) {
      low = 0.0;           // Part of the box lies behind the wall: any part of the wall may serve.
      high = wall.length;
      break;
    }
    const double t = wall.along(c + before / (before - behind) * (r.a - c));
    low = std::min(low, t);
    high = std::max(high, t);
  }
  if (high < 0.0 || low > wall.length) return false;
  out.feet = {wall.a + std::max(low, 0.0) * wall.tangent, wall.a + std::min(high, wall.length) * wall.tangent};
  out.nearest = distance_to_box(r.a, box);
  return out.nearest <= limits.max_mirrored_range;
}

bool candidate_for(const RoomScene& room, const Reflector& r, const Corners& box, const SightLimits& limits, Candidate& out) noexcept {
  if (r.kind == ReflectorKind::wall) return wall_candidate(r, box, limits, out);
  if (r.kind == ReflectorKind::mirrored_corner) return mirrored_candidate(room, r, box, limits, out);
  out.feet = {r.a, r.b};
  if (r.is_point()) {
    out.nearest = distance_to_box(r.a, box);
    return out.nearest <= (r.kind == ReflectorKind::edge ? limits.max_edge_range : limits.max_range);
  }
  const Vec2 centre = 0.5 * (box[0] + box[2]);
  out.nearest = std::max(0.0, distance(out.feet, centre) - 0.5 * distance(box[0], box[2]));
  return out.nearest <= limits.max_range;
}

// Bounding box of some points: most of a large room's walls are ruled out by it alone.
struct Bounds {
  Vec2 low{1e300, 1e300};
  Vec2 high{-1e300, -1e300};
  void include(Vec2 p) noexcept {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  [[nodiscard]] bool misses(const Segment& s) const noexcept {
    return (s.a.x < low.x && s.b.x < low.x) || (s.a.x > high.x && s.b.x > high.x) ||
           (s.a.y < low.y && s.b.y < low.y) || (s.a.y > high.y && s.b.y > high.y);
  }
};

// One blocking piece that cuts off every corner of the box from both ends of the feet cuts off everything in between.
bool blocks_all(const Segment& s, const Corners& box, const Segment& feet) noexcept {
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

Arc directions(const Reflector& r, const Candidate& c, const Corners& box) noexcept {
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

Reach reach_of(const Reflector& r, const Candidate& c, const Corners& box, const SightLimits& limits) noexcept {
  const Arc arc = directions(r, c, box);
  if (r.kind == ReflectorKind::all_reflective) {
    const std::uint32_t sectors = sectors_near(arc, limits.all_reflective_cut_off_rad);
    return {sectors, sectors};
  }
  const double rough = r.kind == ReflectorKind::wall && may_be_rough(c, limits) ? limits.rough_cut_off_rad : 0.0;
  return {sectors_near(arc, std::max(limits.sharp_cut_off_rad, rough)), sectors_near(arc, std::max(limits.cut_off_rad, rough))};
}

void fill_sectors(const RoomScene& room, const std::vector<Candidate>& seen, const Corners& box, const SightLimits& limits, Cell& cell) {
  std::array<Reach, Cell::kMaxEntries> reaches;
  for (std::size_t i = 0; i < seen.size(); ++i) reaches[i] = reach_of(room.reflectors[seen[i].reflector], seen[i], box, limits);
  std::uint16_t used = 0;
  for (std::size_t s = 0; s < Cell::kSectors; ++s) {
    cell.sector_begin[s] = used;
    for (std::size_t i = 0; i < seen.size() && used < Cell::kMaxItems; ++i) {
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
  const Corners box{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
  std::vector<Candidate>& seen = scratch.seen;
  std::vector<std::uint16_t>& between = scratch.between;
  seen.clear();
  for (std::size_t i = 0; i < room.reflectors.size(); ++i) {
    const Reflector& r = room.reflectors[i];
    Candidate c;
    c.reflector = static_cast<std::uint16_t>(i);
    if (!candidate_for(room, r, box, limits, c)) continue;
    const auto through_door = [&] {
      const Opening& door = room.openings[static_cast<std::size_t>(r.opening)];
      return distance_to_box(door.centre, box) < kInDoorway ||
             hull_may_touch<6>({box[0], box[1], box[2], box[3], c.feet.a, c.feet.b}, door.span());
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
    if (mirrored) reach.include(r.real);
    for (std::size_t k = 0; k < room.occluders.size() && !hidden; ++k) {
      if (static_cast<std::int16_t>(k) == r.own_index) continue;
      if (reach.misses(room.occluders[k])) continue;
      if (!hull_may_touch<6>({box[0], box[1], box[2], box[3], c.feet.a, c.feet.b}, room.occluders[k]) &&
          !(mirrored && hull_may_touch<3>({c.feet.a, c.feet.b, r.real}, room.occluders[k]))) {
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
