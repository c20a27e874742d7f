#include "scene/room_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/visibility.hpp"

namespace echoway::scene {
namespace {

constexpr double kDoorReach = 0.45;          // A door's centre may lie this far off the wall it is cut into.
constexpr double kFrameTolerance = 0.5;      // Frames that disagree by more at a door are overruled by the door.
constexpr double kJambTolerance = 0.20;      // An edge this near to a jamb is that jamb.
constexpr double kShortestPiece = 1e-6;      // Pieces of wall shorter than this echo nothing.
constexpr double kSideProbe = 1e-3;          // How far beside a wall its inner side is looked for.
constexpr double kMargin = 0.3;              // Grid around the floor, so that a belt against the wall has a cell.
constexpr int kMaxCellsPerRoom = 16384;

FloorLoops make_floor(const Room& room) {
  FloorLoops floor;
  for (const auto& loop : room.boundary) {
    if (loop.size() < 3) continue;
    floor.begin.push_back(static_cast<std::uint32_t>(floor.vertices.size()));
    floor.vertices.insert(floor.vertices.end(), loop.begin(), loop.end());
  }
  floor.begin.push_back(static_cast<std::uint32_t>(floor.vertices.size()));
  return floor;
}

// The door's transform between its rooms. Frames say it, unless a loop of doors failed to close and the frames disagree
// with the door itself: then the door is what the wearer walks through.
Opening make_opening(const Building& building, RoomIndex from, Vec2 at_from, RoomIndex to, Vec2 at_to, double width) {
  const Pose2 relative = building.room(to).frame.relative(building.room(from).frame);
  Opening o;
  o.to = to;
  o.centre = at_from;
  o.half_width = 0.5 * width;
  o.rotation = unit_from_angle(relative.heading);
  if (relative.heading == 0.0) o.rotation = {1.0, 0.0};
  o.shift = relative.position;
  const Vec2 miss = at_to - o.to_neighbour(at_from);
  o.gap = norm(miss);
  if (o.gap > kFrameTolerance) {
    o.shift = o.shift + miss;
    o.gap = 0.0;
  }
  return o;
}

// Direction of the wall nearest to the opening.
Vec2 wall_direction_at(const Room& room, Vec2 at) {
  double best = std::numeric_limits<double>::infinity();
  Vec2 direction{1.0, 0.0};
  for (const Segment& w : room.walls) {
    const double length = w.length();
    if (!(length > 0.05)) continue;
    const double d = distance(w, at);
    if (d < best) {
      best = d;
      direction = (1.0 / length) * w.direction();
    }
  }
  return direction;
}

// Cuts the openings out of one wall. Appends what is left to `pieces`.
void cut_wall(const Segment& wall, const std::vector<Opening>& openings, std::vector<Segment>& pieces) {
  const double length = wall.length();
  if (!(length > kShortestPiece)) return;
  const Vec2 t = (1.0 / length) * wall.direction();
  std::vector<std::pair<double, double>> holes;
  for (const Opening& o : openings) {
    if (std::abs(cross(t, o.tangent)) > 0.17) continue;
    if (std::abs(cross(t, o.centre - wall.a)) > kDoorReach) continue;
    const double middle = dot(t, o.centre - wall.a);
    if (middle + o.half_width > 0.0 && middle - o.half_width < length) {
      holes.emplace_back(middle - o.half_width, middle + o.half_width);
    }
  }
  std::sort(holes.begin(), holes.end());
  double from = 0.0;
  for (const auto& [begin, end] : holes) {
    if (begin - from > kShortestPiece) pieces.push_back({wall.a + from * t, wall.a + begin * t});
    from = std::max(from, end);
  }
  if (length - from > kShortestPiece) pieces.push_back({wall.a + from * t, from == 0.0 ? wall.b : wall.a + length * t});
}

// True unless walls that meet at `corner` say that it is not a right angle: only a right one returns sound straight
// back.
bool is_right_angle(const Room& room, Vec2 corner) {
  std::vector<Vec2> directions;
  for (const Segment& w : room.walls) {
    if (!(w.length() > 0.02)) continue;
    if (distance(w.a, corner) < 0.02) directions.push_back((1.0 / w.length()) * w.direction());
    if (distance(w.b, corner) < 0.02) directions.push_back((-1.0 / w.length()) * w.direction());
  }
  if (directions.size() < 2) return true;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = i + 1; j < directions.size(); ++j) {
      if (std::abs(dot(directions[i], directions[j])) < 0.06) return true;
    }
  }
  return false;
}

void add_wall(RoomScene& scene, const Segment& piece) {
  const auto own = static_cast<std::int16_t>(scene.occluders.size());
  scene.occluders.push_back(piece);
  const double length = piece.length();
  const Vec2 middle = 0.5 * (piece.a + piece.b);
  const Vec2 left = (kSideProbe / length) * perpendicular(piece.direction());
  const bool left_inside = scene.floor.contains(middle + left);
  const bool right_inside = scene.floor.contains(middle - left);
  Reflector r = make_segment_reflector(ReflectorKind::wall, piece, left_inside || !right_inside);
  r.two_sided = left_inside == right_inside;
  r.own_index = own;
  scene.reflectors.push_back(r);
}

void compile_own(const Room& room, RoomScene& scene) {
  std::vector<Segment> pieces;
  for (const Segment& w : room.walls) cut_wall(w, scene.openings, pieces);
  for (const Segment& p : pieces) add_wall(scene, p);
  for (const Segment& s : room.reflectors) {
    if (!(s.length() > kShortestPiece)) continue;
    Reflector r = make_segment_reflector(ReflectorKind::all_reflective, s, true);
    r.two_sided = true;
    r.own_index = static_cast<std::int16_t>(scene.occluders.size());
    scene.occluders.push_back(s);
    scene.reflectors.push_back(r);
  }
  for (Vec2 c : room.corners) {
    if (is_right_angle(room, c)) scene.reflectors.push_back(make_point_reflector(ReflectorKind::corner, c));
  }
  std::vector<Vec2> edges = room.edges;
  for (const Opening& o : scene.openings) {
    for (const Vec2 jamb : {o.span().a, o.span().b}) {
      const auto near = [&](Vec2 e) { return distance(e, jamb) < kJambTolerance; };
      if (std::none_of(edges.begin(), edges.end(), near)) edges.push_back(jamb);
    }
  }
  for (Vec2 e : edges) scene.reflectors.push_back(make_point_reflector(ReflectorKind::edge, e));
  scene.own_reflectors = static_cast<std::uint32_t>(scene.reflectors.size());
  scene.own_occluders = static_cast<std::uint32_t>(scene.occluders.size());
}

void place_grid(RoomScene& scene, double cell_size, std::uint32_t& next_cell) {
  Bounds floor;
  for (Vec2 v : scene.floor.vertices) floor.include(v);
  if (!scene.floor.vertices.empty()) {
    scene.low = floor.low;
    scene.high = floor.high;
  }
  const Vec2 size = scene.high - scene.low + Vec2{2 * kMargin, 2 * kMargin};
  scene.cell_size = std::max(cell_size, std::sqrt(size.x * size.y / kMaxCellsPerRoom));
  scene.cell_size = std::max(scene.cell_size, std::max(size.x, size.y) / 4096.0);
  scene.cells_per_metre = 1.0 / scene.cell_size;
  scene.columns = std::max(1, static_cast<int>(std::ceil(size.x / scene.cell_size)));
  scene.rows = std::max(1, static_cast<int>(std::ceil(size.y / scene.cell_size)));
  scene.grid_origin = scene.low - Vec2{kMargin, kMargin};
  scene.first_cell = next_cell;
  next_cell += static_cast<std::uint32_t>(scene.columns * scene.rows);
}

struct Frame {
  Vec2 rotation{1.0, 0.0};
  Vec2 shift{};
  [[nodiscard]] Vec2 apply(Vec2 p) const noexcept { return rotated(p, rotation) + shift; }
};

// Takes points of the room beyond `o` into the frame of the room that has `o`.
Frame inverse(const Opening& o) noexcept {
  const Vec2 r{o.rotation.x, -o.rotation.y};
  return {r, -rotated(o.shift, r)};
}

Frame compose(const Frame& outer, const Frame& inner) noexcept {
  return {rotated(inner.rotation, outer.rotation), outer.apply(inner.shift)};
}

bool same_point_exists(const RoomScene& scene, const Reflector& r) {
  return std::any_of(scene.reflectors.begin(), scene.reflectors.end(), [&](const Reflector& o) {
    return o.kind == r.kind && distance(o.a, r.a) < kJambTolerance;
  });
}

// Adds what `beyond` shows through `door` (and, one room further, through `second`).
void add_seen(RoomScene& scene, const RoomScene& beyond, const Frame& frame, std::int16_t door, const Segment& span,
              const Segment* second, double max_range) {
  const auto first_occluder = static_cast<std::int16_t>(scene.occluders.size());
  const std::size_t before = scene.reflectors.size();
  for (std::size_t i = 0; i < beyond.own_reflectors; ++i) {
    const Reflector& source = beyond.reflectors[i];
    Reflector r = transformed(source, frame.rotation, frame.shift);
    const Vec2 nearest = nearest_point(span, nearest_point({r.a, r.b}, span.a));
    if (distance(Segment{r.a, r.b}, nearest) > max_range) continue;
    if (second != nullptr && !hull_may_touch<4>({span.a, span.b, r.a, r.b}, *second)) continue;
    if (r.is_point() && same_point_exists(scene, r)) continue;
    r.opening = door;
    if (source.own_index >= 0) r.own_index = static_cast<std::int16_t>(first_occluder + source.own_index);
    scene.reflectors.push_back(r);
  }
  if (scene.reflectors.size() == before) return;
  for (const Segment& s : beyond.occluders) scene.occluders.push_back({frame.apply(s.a), frame.apply(s.b)});
}

// Two doors in one wall show nothing of each other's rooms.
bool in_line(const Opening& door, const Segment& second) noexcept {
  constexpr double kWallThickness = 0.3;
  return std::abs(cross(door.tangent, second.a - door.centre)) < kWallThickness &&
         std::abs(cross(door.tangent, second.b - door.centre)) < kWallThickness;
}

// The corners of the room as its walls mirror them. Sound that meets a wall aslant goes on to a corner and comes back
// the same way: the longest and commonest of the echoes by more than one reflection.
void add_mirrored_corners(RoomScene& scene, double max_range) {
  constexpr double kShortestMirror = 0.25;
  constexpr std::size_t kMost = 2000;
  const std::size_t own = scene.own_reflectors;
  std::size_t added = 0;
  for (std::size_t w = 0; w < own; ++w) {
    const Reflector wall = scene.reflectors[w];
    if (wall.kind != ReflectorKind::wall || wall.length < kShortestMirror) continue;
    for (std::size_t c = 0; c < own && added < kMost; ++c) {
      if (scene.reflectors[c].kind != ReflectorKind::corner) continue;
      const Vec2 corner = scene.reflectors[c].a;
      const double before = wall.signed_distance(corner);
      if (!(std::abs(before) > kShortestMirror) || (before < 0.0 && !wall.two_sided)) continue;
      Reflector image = make_point_reflector(ReflectorKind::mirrored_corner, corner - 2.0 * before * wall.normal);
      if (distance(Segment{wall.a, wall.b}, image.a) > max_range) continue;
      image.b = corner;
      image.mirror = static_cast<std::int16_t>(w);
      image.own_index = wall.own_index;
      scene.reflectors.push_back(image);
      ++added;
    }
  }
}

}  // namespace

RoomCompiler::RoomCompiler(const Building& building, double max_range, double cell_size)
    : own_(building.rooms.size()), max_range_(max_range) {
  for (const Door& d : building.doors) {
    own_[static_cast<std::size_t>(d.room_a)].openings.push_back(
        make_opening(building, d.room_a, d.at_a, d.room_b, d.at_b, d.width));
    own_[static_cast<std::size_t>(d.room_b)].openings.push_back(
        make_opening(building, d.room_b, d.at_b, d.room_a, d.at_a, d.width));
  }
  std::uint32_t next_cell = 0;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const Room& room = building.rooms[i];
    for (Opening& o : own_[i].openings) o.tangent = wall_direction_at(room, o.centre);
    own_[i].floor = make_floor(room);
    compile_own(room, own_[i]);
    place_grid(own_[i], cell_size, next_cell);
  }
}

RoomScene RoomCompiler::compile(RoomIndex room) const {
  RoomScene scene = own_[static_cast<std::size_t>(room)];
  add_mirrored_corners(scene, max_range_);
  for (std::size_t d = 0; d < scene.openings.size(); ++d) {
    const Opening& door = scene.openings[d];
    const Frame frame = inverse(door);
    const RoomScene& beyond = own_[static_cast<std::size_t>(door.to)];
    add_seen(scene, beyond, frame, static_cast<std::int16_t>(d), door.span(), nullptr, max_range_);
    for (const Opening& next : beyond.openings) {
      if (next.to == room) continue;
      const Segment second{frame.apply(next.span().a), frame.apply(next.span().b)};
      if (in_line(door, second) || distance(second, door.centre) > max_range_) continue;
      add_seen(scene, own_[static_cast<std::size_t>(next.to)], compose(frame, inverse(next)),
               static_cast<std::int16_t>(d), door.span(), &second, max_range_);
    }
  }
  return scene;
}

}  // namespace echoway::scene
