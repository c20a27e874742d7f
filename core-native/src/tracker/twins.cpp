#include "tracker/twins.hpp"

#include "tracker/elementary.hpp"
#include "tracker/floor.hpp"

namespace echoway::tracker {
namespace {

constexpr double kOdds = 0.1;             // Of all twins of a place together, against it.
constexpr std::size_t kEach = 5;          // One particle of so many is enough to tell where the twin is.
constexpr double kSquare = 1.1;           // A room whose sides differ by no more may look the same turned by a quarter.
constexpr Vec2 kHalfTurn{-1.0, 0.0}, kLeft{0.0, 1.0}, kRight{0.0, -1.0};   // Cosines and sines.

bool is_square(Vec2 size) noexcept { return size.x < kSquare * size.y && size.y < kSquare * size.x; }

// With the room, about its centre.
Particle turned_about(Vec2 centre, Vec2 rotation, Particle p) noexcept {
  const Vec2 from = p.position - centre;
  p.position = centre + Vec2{rotation.x * from.x - rotation.y * from.y, rotation.y * from.x + rotation.x * from.y};
  p.strangers.fill(0);   // What answered from nothing in the plan was told from the other place.
  turn(p, rotation);
  return p;
}

}  // namespace

void add_twins(Population& population, const scene::Scene& scene) noexcept {
  const std::size_t found = population.size();
  for (std::size_t i = kEach / 2; i < found; i += kEach) {
    const Particle p = population.particles()[i];
    const scene::RoomScene& room = scene.room(p.room);
    const bool square = is_square(room.high - room.low);
    const double odds = square ? kOdds / 3.0 : kOdds;
    for (const Vec2 rotation : {kHalfTurn, kLeft, kRight}) {
      if (rotation.x == 0.0 && !square) continue;
      Particle twin = turned_about(0.5 * (room.low + room.high), rotation, p);
      twin.weight *= odds * static_cast<double>(kEach);
      if (can_stand(room, twin.position)) population.push(twin);
    }
  }
  population.normalize();
}

}  // namespace echoway::tracker
