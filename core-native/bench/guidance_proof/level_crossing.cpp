#include "level_crossing.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::proof {
namespace {

constexpr double kTurnRate = degrees(90.0);
constexpr double kTurnPerStep = degrees(50.0);
constexpr double kSpeed = 0.7;  // On the landing, m/s.
constexpr double kStepLength = 0.6;
constexpr double kCabinComes = 5.0;
constexpr double kCabinStorey = 3.0;

}  // namespace

LevelCrossing::LevelCrossing(LevelLinkKind kind, int storeys, bool up, int hand) : kind_(kind), hand_(hand) {
  if (kind == LevelLinkKind::elevator) {
    keys_.push_back({});
    stand(kPi / kTurnRate, kPi);
    stand(kCabinComes + kCabinStorey * storeys, 0.0);
    return;
  }
  keys_.push_back({0.0, sim::stairs::path(up, hand).front(), 0.0, 0.0});
  for (int i = 0; i < storeys; ++i) {
    if (i > 0) {
      for (const Vec2 p : sim::stairs::landing(up, hand)) walk(p);
    }
    for (const Vec2 p : sim::stairs::path(up, hand)) walk(p);
  }
}

void LevelCrossing::stand(double seconds, double turn) {
  Key key = keys_.back();
  key.time_s += seconds;
  key.heading += turn;
  key.steps += std::abs(turn) / kTurnPerStep;
  keys_.push_back(key);
}

void LevelCrossing::walk(Vec2 to) {
  const Vec2 way = to - keys_.back().at;
  const double length = norm(way);
  if (length < 1e-6) return;
  const double turn = wrap_angle(std::atan2(way.y, way.x) - keys_.back().heading);
  if (std::abs(turn) > 1e-6) stand(std::abs(turn) / kTurnRate, turn);
  const bool flight = sim::stairs::on_flight(keys_.back().at + 0.5 * way);
  Key key = keys_.back();
  key.time_s += length / (flight ? sim::stairs::kCadence * sim::stairs::kGoing : kSpeed);
  key.steps += length / (flight ? sim::stairs::kGoing : kStepLength);
  key.at = to;
  keys_.push_back(key);
}

LevelCrossing::Moment LevelCrossing::at(double share) const {
  const double time = std::clamp(share, 0.0, 1.0) * keys_.back().time_s;
  std::size_t i = 1;
  while (i + 1 < keys_.size() && keys_[i].time_s < time) ++i;
  const Key& a = keys_[i - 1];
  const Key& b = keys_[i];
  const double f = b.time_s > a.time_s ? (time - a.time_s) / (b.time_s - a.time_s) : 1.0;
  const double heading = a.heading + f * (b.heading - a.heading);
  Moment moment;
  moment.place = {true, kind_, hand_, {a.at + f * (b.at - a.at), wrap_angle(heading)}};
  moment.turned = heading;
  moment.steps = a.steps + f * (b.steps - a.steps);
  return moment;
}

}  // namespace echoway::proof
