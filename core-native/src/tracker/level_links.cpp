#include "tracker/level_links.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"
#include "tracker/motion.hpp"

namespace echoway::tracker {
namespace {

constexpr double kReach = 1.2;               // Metres from a link's end within which somebody may be taking it.
constexpr double kFinds = 2.0;               // Metres from where who was told to take it finds it.
constexpr double kUntoldRate = 0.15;         // 1/s, of those told nothing: who comes so near often means to take it.
constexpr double kLedRate = 0.002;           // 1/s, of those who are led elsewhere.
constexpr double kToldRate = 1.5;            // 1/s.
// How long people are on the way: never less, at this rate (1/s) from then on, never longer.
struct Ride {
  double shortest_s;
  double end_rate;
  double longest_s;
};
constexpr Ride kStairs{8.0, 0.12, 45.0};     // A storey of two flights takes some seventeen seconds.
constexpr Ride kElevator{8.0, 0.06, 90.0};
constexpr double kWaitRate = 5.0;            // 1/s: who is led stands where they came out until told how it goes on.
constexpr double kObedience = 0.9;           // Who was told to go up and sets out goes up.
constexpr double kLandingSigma = 0.6;        // Metres: where somebody steps off.
constexpr double kLandingTurnSigma = degrees(8.0);

bool happens(double rate, double seconds, Random& random) noexcept {
  return random.uniform() < 1.0 - fast_exp(-rate * seconds);
}

void stand(Particle& p) noexcept {
  p.gait = Gait::standing;
  forget_speed(p, 0.0, MotionParameters{}.standing_sigma);
}

}  // namespace

LevelLinks::LevelLinks(const Building& building) {
  for (std::size_t i = 0; i < building.links.size(); ++i) {
    const LevelLink& l = building.links[i];
    const double turn = wrap_angle(building.room(l.room_a).frame.heading - building.room(l.room_b).frame.heading);
    const bool stairs = l.kind == LevelLinkKind::stairs;
    ends_.push_back({i, l.room_a, l.at_a, l.room_b, l.at_b, turn, stairs});
    ends_.push_back({i, l.room_b, l.at_b, l.room_a, l.at_a, -turn, stairs});
  }
  std::stable_sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return a.room < b.room; });
  first_.assign(building.rooms.size() + 1, 0);
  for (const End& end : ends_) ++first_[static_cast<std::size_t>(end.room) + 1];
  for (std::size_t r = 1; r < first_.size(); ++r) first_[r] += first_[r - 1];
}

const LevelTransition* LevelLinks::expected(double time_s) const noexcept {
  return told_ && time_s < told_->time_s + told_->patience_s ? &*told_ : nullptr;
}

bool LevelLinks::begins_near(const LevelTransition& transition, const Particle& p) const noexcept {
  return std::any_of(ends_.begin(), ends_.end(), [&](const End& end) {
    return end.link == transition.link && end.room == transition.from && p.room == end.room &&
           squared_norm(p.position - end.at) < kFinds * kFinds;
  });
}

bool LevelLinks::told(const End& end, double time_s) const noexcept {
  const LevelTransition* t = expected(time_s);
  return t != nullptr && t->link == end.link && t->from == end.room;
}

double LevelLinks::setting_out_rate(const End& end, double time_s) const noexcept {
  if (told(end, time_s)) return kToldRate;
  return led_ ? kLedRate : kUntoldRate;
}

bool LevelLinks::same_place(const End& a, const End& b) const noexcept {
  return a.stairs == b.stairs && squared_norm(a.at - b.at) < kReach * kReach;
}

const LevelLinks::End& LevelLinks::pick(const End& end, std::uint64_t turn) const noexcept {
  const auto room = static_cast<std::size_t>(end.room);
  std::uint64_t count = 0;
  for (std::uint32_t i = first_[room]; i < first_[room + 1]; ++i) count += same_place(ends_[i], end) ? 1 : 0;
  std::uint64_t skip = count > 0 ? turn % count : 0;
  for (std::uint32_t i = first_[room]; i < first_[room + 1]; ++i) {
    if (same_place(ends_[i], end) && skip-- == 0) return ends_[i];
  }
  return end;
}

const LevelLinks::End& LevelLinks::way_taken(const End& end, double time_s, Random& random) const noexcept {
  if (told(end, time_s) && random.uniform() < kObedience) return end;
  return pick(end, random.next() >> 32);
}

LevelLinks::Landing LevelLinks::landing(const Particle& away, std::uint64_t turn) const noexcept {
  const End& end = pick(ends_[static_cast<std::size_t>(away.link_end)], turn);
  return {end.to, end.to_at, end.turn};
}

void LevelLinks::step(Particle& p, double time_s, double seconds, bool turn_known, Random& random) const noexcept {
  if (p.gait == Gait::away) {
    const End& end = ends_[static_cast<std::size_t>(p.link_end)];
    p.away_s += seconds;
    const Ride& ride = end.stairs ? kStairs : kElevator;
    if (p.away_s < ride.shortest_s) return;
    if (p.away_s > ride.longest_s || happens(ride.end_rate, seconds, random)) land(p, time_s, turn_known, random);
    return;
  }
  if (p.gait == Gait::walking && awaits_word(p, time_s) && happens(kWaitRate, seconds, random)) stand(p);
  const auto room = static_cast<std::size_t>(p.room);
  for (std::uint32_t i = first_[room]; i < first_[room + 1]; ++i) {
    const End& end = ends_[i];
    const double reach = told(end, time_s) ? kFinds : kReach;
    if (squared_norm(p.position - end.at) > reach * reach) continue;
    if (!happens(setting_out_rate(end, time_s), seconds, random)) continue;
    p.gait = Gait::away;
    p.away_s = 0.0;
    p.link_end = static_cast<std::int32_t>(i);
    if (!end.stairs) p.speed = 0.0;
    return;
  }
}

void LevelLinks::land(Particle& away, double time_s, bool turn_known, Random& random) const noexcept {
  arrive(away, way_taken(ends_[static_cast<std::size_t>(away.link_end)], time_s, random), turn_known, random);
}

bool LevelLinks::awaits_word(const Particle& p, double time_s) const noexcept {
  const LevelTransition* transition = expected(time_s);
  return led_ && transition != nullptr && p.room == transition->to;
}

void LevelLinks::arrive(Particle& p, const End& end, bool turn_known, Random& random) const noexcept {
  p.room = end.to;
  p.position = end.to_at;
  p.heading = turn_known ? p.heading + end.turn + kLandingTurnSigma * cheap_normal(random) : random.uniform(-kPi, kPi);
  p.heading = wrap_near(p.heading);
  face_heading(p);
  p.gait = end.stairs ? Gait::walking : Gait::standing;
  const double scale = p.cov.kk;
  p.cov = {};
  p.cov.xx = p.cov.yy = kLandingSigma * kLandingSigma;
  p.cov.ss = 0.2 * 0.2;
  p.cov.kk = scale;
  if (led_) stand(p);
  p.strangers.forget();
}

}  // namespace echoway::tracker
