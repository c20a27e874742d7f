// Poses that the geometry cannot observe: the tracker must say so, in the direction that it concerns.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "echoway/acoustics/detection.hpp"
#include "echoway/acoustics/range_model.hpp"
#include "echoway/session.hpp"
#include "echoway/sim/simulate.hpp"
#include "plans/plans.hpp"
#include "stiff/case.hpp"

namespace echoway::stiff {
namespace {

/// A symmetric 2 x 2 matrix's eigenvalues.
struct Spread {
  double large = 0.0;
  double small = 0.0;

  /// Of the matrix or of its inverse alike; infinite when one direction is not observed at all.
  [[nodiscard]] double condition() const { return small > 0.0 ? large / small : INFINITY; }
};

Spread eigenvalues(double xx, double xy, double yy) {
  const double middle = 0.5 * (xx + yy);
  const double half = std::hypot(0.5 * (xx - yy), xy);
  // The smaller one from the product: the difference would lose every digit where the condition is bad.
  const double large = middle + half;
  return {large, large > 0.0 ? std::fmax(0.0, (xx * yy - xy * xy) / large) : 0.0};
}

Building hall(double length) { return plans::alone(plans::box_room("hall", length, 2.4)); }

/// The information that one scan's specular ranges hold about the position, at 1 % noise: sum of u u^T / sigma^2 over
/// the sensors that hear something, u the direction to the reflector.
Spread information(const Room& room, const Pose2& pose) {
  const BeltConfig belt;
  const RangeModel model(room, {}, belt, DetectionTable(belt));
  constexpr double kStep = 1e-5;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (int sensor = 0; sensor < belt.sensors; ++sensor) {
    const PredictedEcho here = model.predict(pose, sensor);
    if (!here.has_echo()) continue;
    const auto gradient = [&](Vec2 step) {
      const PredictedEcho there = model.predict({pose.position + step, pose.heading}, sensor);
      return there.kind == here.kind && there.index == here.index ? (there.range_m - here.range_m) / kStep : 0.0;
    };
    const double gx = gradient({kStep, 0.0});
    const double gy = gradient({0.0, kStep});
    const double weight = 1.0 / std::pow(belt.range_noise * here.range_m, 2);
    xx += weight * gx * gx;
    xy += weight * gx * gy;
    yy += weight * gy * gy;
  }
  return eigenvalues(xx, xy, yy);
}

struct Stay {
  Estimate last{};
  Pose2 truth{};
  std::string broken;
};

/// What a wearer without any motion sensor does in the hall: walks 12 m along it, or stands.
struct Doing {
  bool walking = false;
  double standing_s = 30.0;
  std::uint64_t seed = 8;
};

/// One who does that, followed from `start`.
Stay stay(double length, const Doing& doing, const Start& start) {
  const Building building = hall(length);
  sim::Walk walk;
  walk.seed = doing.seed;
  walk.start = {"hall", {0.5 * length - 6.0, 1.1}};
  walk.world = sim::make_world(sim::Profile::empty);
  walk.world.gyro = walk.world.steps = walk.world.heading = false;
  if (doing.walking) {
    walk.add(sim::GoTo{{"hall", {0.5 * length + 6.0, 1.2}}});
  } else {
    walk.add(sim::Pause{doing.standing_s});
  }
  const Result<sim::Simulation> heard = sim::simulate(building, walk);
  if (!heard) return {{}, {}, heard.error().to_string()};
  SessionConfig config;
  config.start = start;
  auto session = Session::open(building, config);
  if (!session) return {{}, {}, session.error().message};
  for (const Firing& f : heard->scans.firings) (*session)->on_firing(f);
  return {(*session)->estimate(), heard->truth.back().pose, {}};
}

double off_along(const Stay& s) { return std::fabs(s.last.pose.position.x - s.truth.position.x); }
double sigma_along(const Stay& s) { return std::sqrt(s.last.covariance_xx); }

std::string describe(const Stay& s, const Spread& covariance) {
  char text[160];
  std::snprintf(text, sizeof text, "sigma %.2f m along, %.2f m across, condition %.0f; %.2f m off along",
                sigma_along(s), std::sqrt(s.last.covariance_yy), covariance.condition(), off_along(s));
  return text;
}

/// `least_sigma`: the least that may be claimed.
Outcome admits(const Stay& s, double least_sigma) {
  if (!s.broken.empty()) return holds("runs", false, s.broken);
  const Spread covariance = eigenvalues(s.last.covariance_xx, s.last.covariance_xy, s.last.covariance_yy);
  const bool worst_is_sigma = std::fabs(s.last.sigma_m * s.last.sigma_m / covariance.large - 1.0) < 1e-9;
  const bool good = sigma_along(s) >= least_sigma && off_along(s) <= 3.0 * sigma_along(s) && worst_is_sigma;
  return holds("at least " + number(least_sigma) +
                   " m along the hall, the truth within 3 sigma, sigma_m along the worst direction",
               good, describe(s, covariance));
}

/// Those who stand in such a hall, by how far the estimate has run off for what it claims. Nothing tells standing from
/// walking there, and most people do not stand for long: what is known of the place fades in time.
std::vector<Stay> standing(std::uint64_t walks, double length, double seconds, const Start& start) {
  std::vector<Stay> all;
  for (std::uint64_t seed = 1; seed <= walks; ++seed) all.push_back(stay(length, {false, seconds, seed}, start));
  std::ranges::sort(all, {}, [](const Stay& s) {
    return s.broken.empty() ? off_along(s) / sigma_along(s) : INFINITY;
  });
  return all;
}

}  // namespace

void add_conditioning(std::vector<Case>& table) {
  const auto add = [&](std::string title, std::function<Outcome()> run) {
    table.push_back({"Conditioning", std::move(title), std::move(run)});
  };
  add("information of one scan in the middle of a 60 x 2.4 m hall, facing along it", [] {
    const Spread s = information(hall(60.0).rooms[0], {{30.0, 1.1}, 0.0});
    return holds("nothing along the hall: condition above 1e12", s.condition() > 1e12,
                 "condition " + number(s.condition()));
  });
  add("information of one scan 3 m from the end of that hall", [] {
    const Spread s = information(hall(60.0).rooms[0], {{57.0, 1.1}, 0.0});
    return holds("both directions: condition below 1e3", s.condition() < 1e3, "condition " + number(s.condition()));
  });
  add("information of one scan in the middle of a 5 x 4 m room", [] {
    const Spread s = information(plans::box_room("box", 5.0, 4.0), {{2.5, 2.0}, 0.0});
    return holds("both directions: condition below 10", s.condition() < 10.0, "condition " + number(s.condition()));
  });
  add("standing in the hall's middle for 15 s, place in it unknown, the middle one of 7", [] {
    return admits(standing(7, 60.0, 15.0, {0, std::nullopt, std::nullopt})[3], 5.0);
  });
  add("standing in the hall's middle for 10 s, place known to 0.3 m, the worst of 12", [] {
    return admits(standing(12, 60.0, 10.0, {0, Vec2{24.0, 1.1}, 0.0}).back(), 0.15);
  });
  add("12 m along the hall without gyroscope and steps, place unknown", [] {
    return admits(stay(60.0, {.walking = true}, {0, std::nullopt, std::nullopt}), 3.0);
  });
  add("12 m along the hall without gyroscope and steps, start known", [] {
    return admits(stay(60.0, {.walking = true}, {0, Vec2{24.0, 1.1}, 0.0}), 0.5);
  });
}

}  // namespace echoway::stiff
