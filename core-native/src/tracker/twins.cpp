#include "tracker/twins.hpp"

#include <array>
#include <span>

#include "tracker/floor.hpp"

namespace echoway::tracker {
namespace {

constexpr double kOdds = 0.1;             // Of all twins of a place together, against it.
constexpr std::size_t kEach = 5;          // One particle of so many is enough to tell where the twin is.
constexpr double kSquare = 1.1;           // A room whose sides differ by no more may look the same turned by a quarter.
constexpr std::array<Vec2, 3> kTurns{{{-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};   // Cosine, sine: half a turn, quarters.

// By which a room may look the same.
std::span<const Vec2> turns_of(const scene::RoomScene& room) noexcept {
  const Vec2 size = room.high - room.low;
  const bool square = size.x < kSquare * size.y && size.y < kSquare * size.x;
  return std::span(kTurns).first(square ? kTurns.size() : 1);
}

// With the room, about its centre.
Particle turned_about(Vec2 centre, Vec2 rotation, Particle p) noexcept {
  const Vec2 from = p.position - centre;
  p.position = centre + rotated(from, rotation);
  p.strangers.forget();   // Or nothing would surprise a twin: what it cannot explain would just answer again.
  p.fronts.forget();      // They stand before the other walls.
  turn(p, rotation);
  return p;
}

}  // namespace

std::size_t without_twins(std::size_t capacity) noexcept { return capacity * kEach / (kEach + kTurns.size()); }

void add_twins(Population& population, const scene::Scene& scene) noexcept {
  const std::size_t found = population.size();
  for (std::size_t i = kEach / 2; i < found; i += kEach) {
    const Particle p = population.particles()[i];
    const scene::RoomScene& room = scene.room(p.room);
    const std::span<const Vec2> turns = turns_of(room);
    const double odds = kOdds / static_cast<double>(turns.size());
    for (const Vec2 rotation : turns) {
      Particle twin = turned_about(0.5 * (room.low + room.high), rotation, p);
      twin.weight *= odds * static_cast<double>(kEach);
      if (can_stand(room, twin.position)) population.push(twin);
    }
  }
  population.normalize();
}

}  // namespace echoway::tracker
