#include "rays/things.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "echoway/building/opening.hpp"
#include "echoway/geometry/box.hpp"

namespace echoway::rays {
namespace {

constexpr double kTouching = 0.02;        // Metres.
constexpr double kClearOfWay = 0.35;      // Metres between the wearer's axis and what stands beside the way,
constexpr double kClearOfDoor = 0.6;      // and between a door's centre and anything.
constexpr int kTries = 20;

bool stands_between(const Disc& disc, Vec2 from, Vec2 to) noexcept {
  return distance(disc.centre, from) > disc.radius + kTouching && distance(disc.centre, to) > disc.radius + kTouching &&
         distance(Segment{from, to}, disc.centre) < disc.radius;
}

class Furnisher {
 public:
  Furnisher(const Building& building, std::span<const Vec2> way, Random& random)
      : building_(building), way_(way), random_(random), openings_(find_openings(building)) {}

  Things furnish() {
    for (std::size_t r = 0; r < building_.rooms.size(); ++r) add_plan(r);
    things_.walls = things_.planes.size();
    for (std::size_t r = 0; r < building_.rooms.size(); ++r) add_furniture(r);
    return std::move(things_);
  }

 private:
  void add_plan(std::size_t r) {
    const Room& room = building_.rooms[r];
    const auto placed = [&](const Segment& s) { return Segment{room.frame.transform(s.a), room.frame.transform(s.b)}; };
    for (const Segment& wall : walls_with_doors_open(room, openings_[r])) things_.planes.push_back(placed(wall));
    for (const Segment& bench : room.reflectors) things_.benches.push_back(placed(bench));
    for (const Vec2 corner : room.corners) things_.corners.push_back(room.frame.transform(corner));
    for (const Vec2 edge : room.edges) things_.edges.push_back(room.frame.transform(edge));
    for (const DoorOpening& door : openings_[r]) {
      const Segment span = placed(door.span);
      things_.edges.insert(things_.edges.end(), {span.a, span.b});
      doors_.push_back(0.5 * (span.a + span.b));
    }
  }

  void add_furniture(std::size_t r) {
    const Room& room = building_.rooms[r];
    const echoway::Box box = box_about(room.walls);
    const double area = (box.high.x - box.low.x) * (box.high.y - box.low.y);
    const auto so_many = [&](double low, double high) {
      return static_cast<int>(random_.uniform(low, high) * area + random_.uniform());
    };
    for (int left = so_many(0.02, 0.16); left > 0; --left) add_cupboard(room, box);
    for (int left = so_many(0.02, 0.12); left > 0; --left) add_post(room, box);
    if (random_.uniform() < 0.01 * area) things_.people.push_back({room.frame.transform(somewhere(box)), 0.22});
  }

  Vec2 somewhere(const echoway::Box& box) {
    return {random_.uniform(box.low.x, box.high.x), random_.uniform(box.low.y, box.high.y)};
  }

  bool is_clear(Vec2 at, double radius) const {
    const auto far = [at](double metres) { return [at, metres](Vec2 p) { return distance(p, at) > metres; }; };
    return std::ranges::all_of(way_, far(radius + kClearOfWay)) && std::ranges::all_of(doors_, far(kClearOfDoor));
  }

  // Most stand with their backs to a wall.
  void add_cupboard(const Room& room, const echoway::Box& box) {
    for (int left = kTries; left > 0; --left) {
      const Vec2 half{random_.uniform(0.2, 0.8), random_.uniform(0.15, 0.4)};
      Pose2 pose{somewhere(box), 0.0};
      switch (static_cast<int>(random_.uniform(0.0, 6.0))) {
        case 0: pose = {{pose.position.x, box.low.y + half.y}, 0.0}; break;
        case 1: pose = {{pose.position.x, box.high.y - half.y}, 0.0}; break;
        case 2: pose = {{box.low.x + half.y, pose.position.y}, 0.5 * kPi}; break;
        case 3: pose = {{box.high.x - half.y, pose.position.y}, 0.5 * kPi}; break;
        default: pose.heading = random_.uniform(-kPi, kPi);
      }
      pose = room.frame.compose(pose);
      if (is_clear(pose.position, norm(half))) return add_box(pose, half);
    }
  }

  void add_box(const Pose2& pose, Vec2 half) {
    const std::array<Vec2, 4> corners{pose.transform(half), pose.transform({-half.x, half.y}), pose.transform(-half),
                                      pose.transform({half.x, -half.y})};
    for (std::size_t i = 0; i < corners.size(); ++i) things_.planes.push_back({corners[i], corners[(i + 1) % 4]});
    things_.edges.insert(things_.edges.end(), corners.begin(), corners.end());
  }

  void add_post(const Room& room, const echoway::Box& box) {
    for (int left = kTries; left > 0; --left) {
      const Disc post{room.frame.transform(somewhere(box)), random_.uniform(0.02, 0.08)};
      if (is_clear(post.centre, post.radius)) return things_.posts.push_back(post);
    }
  }

  const Building& building_;
  std::span<const Vec2> way_;
  Random& random_;
  std::vector<std::vector<DoorOpening>> openings_;
  std::vector<Vec2> doors_;
  Things things_;
};

}  // namespace

std::optional<Vec2> crossing(const Segment& segment, Vec2 from, Vec2 to) noexcept {
  const Vec2 way = to - from;
  const double across = cross(way, segment.direction());
  if (across == 0.0) return {};
  const double along_way = cross(segment.a - from, segment.direction()) / across;
  const double along_segment = cross(segment.a - from, way) / across;
  const bool within = along_way > 0.0 && along_way < 1.0 && along_segment > 0.0 && along_segment < 1.0;
  return within ? std::optional(from + along_way * way) : std::nullopt;
}

bool Things::in_sight(Vec2 from, Vec2 to) const noexcept {
  const double way = distance(from, to);
  if (way < 2.0 * kTouching) return true;
  const Vec2 touching = (kTouching / way) * (to - from);
  const auto blocks = [&](const Segment& s) { return crossing(s, from + touching, to - touching).has_value(); };
  const auto stands = [&](const Disc& d) { return stands_between(d, from, to); };
  return std::ranges::none_of(planes, blocks) && std::ranges::none_of(benches, blocks) &&
         std::ranges::none_of(posts, stands) && std::ranges::none_of(people, stands);
}

Things furnish(const Building& building, std::span<const Vec2> way, Random& random) {
  return Furnisher(building, way, random).furnish();
}

}  // namespace echoway::rays
