#include "tracker/echo_memory.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {

constexpr double kSameSpot = 0.30;          // Metres.
constexpr double kFirstStrength = 0.12;     // One sighting may have been a person or a ghost.
constexpr double kGrowth = 0.25;            // Share of what is missing to kMostStrength that a further sighting adds.
constexpr double kMostStrength = 0.7;
constexpr double kRecallDistance = 0.8;     // Between range and spot, metres: more than any particle is off.
constexpr double kRecallCosine = 0.90;      // 25 degrees off the axis.

}  // namespace

std::span<const Spot> EchoMemory::recall(RoomIndex room, Vec2 eye, Vec2 axis, double distance) noexcept {
  std::size_t count = 0;
  for (const Spot& s : spots_) {
    if (s.room != room || s.strength <= 0.0) continue;
    const Vec2 way = s.at - eye;
    const double d2 = squared_norm(way);
    const double low = std::max(0.0, distance - kRecallDistance), high = distance + kRecallDistance;
    if (d2 < low * low || d2 > high * high) continue;
    const double along = dot(way, axis);
    if (along <= 0.0 || along * along < kRecallCosine * kRecallCosine * d2) continue;
    recalled_[count++] = s;
    if (count == kMostRecalled) break;
  }
  return {recalled_.data(), count};
}

void EchoMemory::note(RoomIndex room, Vec2 at, double chance, double time_s) noexcept {
  Spot* nearest = nullptr;
  Spot* weakest = &spots_[0];
  double best2 = kSameSpot * kSameSpot;
  for (Spot& s : spots_) {
    const double d2 = squared_norm(s.at - at);
    if (s.room == room && s.strength > 0.0 && d2 < best2) {
      best2 = d2;
      nearest = &s;
    }
    const bool weaker = s.strength < weakest->strength ||
                        (s.strength == weakest->strength && s.last_seen_s < weakest->last_seen_s);
    if (weaker) weakest = &s;
  }
  if (nearest != nullptr) {
    nearest->at = nearest->at + 0.3 * (at - nearest->at);
    nearest->strength += kGrowth * chance * (kMostStrength - nearest->strength);
    nearest->last_seen_s = time_s;
  } else {
    *weakest = {room, at, kFirstStrength * chance, time_s};
  }
}

void EchoMemory::clear() noexcept { spots_.fill({}); }

}  // namespace echoway::tracker
