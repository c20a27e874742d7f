#include "belt/ballasts.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/vec2.hpp"
#include "streams.hpp"

namespace echoway::sim {
namespace {

constexpr double kLevelAtLamp = 5.0;  // Over threshold at 2 m, facing a lamp that is kNear away.
constexpr double kNear = 1.5;         // Metres; lamps hang at the ceiling and are never nearer.
constexpr double kFlickerDb = 0.7;
constexpr double kSquareMetresPerLamp = 12.0;

}  // namespace

bool Ballasts::lit(RoomIndex room) const {
  const auto switched = switched_.find(room);
  if (switched != switched_.end()) return switched->second;
  return share_ > 0.0 && stream(seed_, Stream::lights, static_cast<std::uint64_t>(room)).uniform() < share_;
}

double Ballasts::level(RoomIndex room, Vec2 face, Vec2 axis, double flicker) {
  if (!lit(room)) return 0.0;
  auto [lamps, fresh] = lamps_.try_emplace(room);
  if (fresh) {
    Random random = stream(seed_, Stream::lights, static_cast<std::uint64_t>(room)).split();
    const int count = 1 + static_cast<int>(floor_area(plan_.building().room(room)) / kSquareMetresPerLamp);
    for (int i = 0; i < count; ++i) lamps->second.push_back(plan_.grid(room).random_place(random).value_or(Vec2{}));
  }
  double strongest = 0.0;
  for (const Vec2 lamp : lamps->second) {
    const Vec2 to = lamp - face;
    const double away = norm(to);
    const double facing = away > 1e-6 ? std::max(0.0, dot(to, axis) / away) : 1.0;
    const double near = kNear / hypotenuse(kNear, away);
    strongest = std::max(strongest, kLevelAtLamp * near * near * facing * facing);
  }
  return strongest * std::pow(10.0, kFlickerDb * flicker / 20.0);
}

}  // namespace echoway::sim
