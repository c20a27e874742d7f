#include "scene/passers_by.hpp"

#include <algorithm>

#include "streams.hpp"

namespace echoway::sim {
namespace {

constexpr double kGirth = 0.2;       // Radius of a person, metres.
constexpr double kClothes = 0.4;     // Reflectivity.
constexpr double kPoliteness = 0.6;  // Distance kept from the wearer, axis to axis, metres.

}  // namespace

void PassersBy::add(const View& view, double time_s, Vec2 wearer, std::vector<Obstacle>& obstacles) {
  if (per_100m2_ <= 0.0) return;
  for (const View::PlacedRoom& placed : view.rooms()) {
    for (Person& person : of(placed.room, time_s)) {
      Vec2 at = placed.frame.transform(person.at(time_s, plan_.grid(placed.room)));
      const double away = distance(at, wearer);
      if (away < kPoliteness) {
        const Vec2 aside = away > 1e-6 ? (1.0 / away) * (at - wearer) : Vec2{1.0, 0.0};
        at = wearer + kPoliteness * aside;
      }
      obstacles.push_back({at, kGirth, kClothes});
    }
  }
}

std::vector<PassersBy::Person>& PassersBy::of(RoomIndex room, double time_s) {
  const auto known = people_.find(room);
  if (known != people_.end()) return known->second;
  std::vector<Person> people;
  Random random = stream(seed_, Stream::people, static_cast<std::uint64_t>(room));
  const double mean = per_100m2_ / 100.0 * floor_area(plan_.building().room(room));
  const int count = static_cast<int>(mean) + (random.uniform() < mean - static_cast<int>(mean) ? 1 : 0);
  for (int i = 0; i < count; ++i) {
    Person person;
    person.random = random.split();
    const std::optional<Vec2> place = plan_.grid(room).random_place(person.random);
    if (!place) break;
    person.from = *place;
    person.left_at_s = time_s;
    person.speed = person.random.uniform(0.5, 1.3);
    people.push_back(std::move(person));
  }
  return people_.emplace(room, std::move(people)).first->second;
}

Vec2 PassersBy::Person::at(double time_s, const RoomGrid& grid) {
  for (;;) {
    if (time_s <= left_at_s) return from;
    if (way.empty()) {
      way = grid.path(from, grid.random_place(random).value_or(from));
      std::reverse(way.begin(), way.end());
      left_at_s += random.uniform(0.0, 15.0);
      if (way.empty()) left_at_s += 5.0;
      continue;
    }
    const double leg = distance(from, way.back());
    const double gone = (time_s - left_at_s) * speed;
    if (gone < leg) return from + (gone / leg) * (way.back() - from);
    left_at_s += leg / speed;
    from = way.back();
    way.pop_back();
  }
}

}  // namespace echoway::sim
