#include "wearer/phone.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::sim {
namespace {

void sense_steps(const Trajectory& trajectory, const World& world, Random random, std::vector<MotionHint>& hints) {
  const auto report = [&](double time_s) {
    hints.push_back({time_s + random.uniform(0.0, world.step_delay_s), MotionKind::step, 1.0});
  };
  double steps_done = 0.0;
  for (const Moment& moment : trajectory.samples()) {
    const double steps = std::floor(moment.stride / kPi);
    if (steps > steps_done && random.uniform() >= world.step_missed) report(moment.time_s);
    steps_done = steps;
    if (random.uniform() < world.step_invented_per_min / 60.0 * Trajectory::kStep) report(moment.time_s);
  }
}

// A phone on the trunk turns as the chest does; one on a thigh swings besides.
double turned(const Moment& moment, const World& world) {
  return moment.yaw + gait_of(moment.speed) * world.phone_swing_rad * std::sin(moment.stride);
}

// The mean rate since the last report, as a gyroscope with an anti-alias filter gives it.
void sense_yaw(const Trajectory& trajectory, const World& world, Random random, std::vector<MotionHint>& hints) {
  const double period = 1.0 / world.gyro_rate_hz;
  const double bias = world.gyro_bias_rad_s;
  double before = turned(trajectory.at(0.0), world);
  for (double t = period; t <= trajectory.duration(); t += period) {
    const double yaw = turned(trajectory.at(t), world);
    hints.push_back(
        {t, MotionKind::yaw_rate, (yaw - before) / period + bias + world.gyro_noise_rad_s * random.normal()});
    before = yaw;
  }
}

void sense_heading(const Trajectory& trajectory, const World& world, Random random, std::vector<MotionHint>& hints) {
  constexpr double kPeriod = 0.1;
  for (double t = 0.0; t <= trajectory.duration(); t += kPeriod) {
    const double error = world.heading_offset_rad + world.heading_drift_rad_s * t + degrees(0.5) * random.normal();
    hints.push_back({t, MotionKind::heading, wrap_angle(trajectory.at(t).heading + error)});
  }
}

}  // namespace

std::vector<MotionHint> sense_motion(const Trajectory& trajectory, const World& world, Random random) {
  std::vector<MotionHint> hints;
  Random of_steps = random.split();
  Random of_yaw = random.split();
  Random of_heading = random.split();
  if (world.steps) sense_steps(trajectory, world, of_steps, hints);
  if (world.gyro) sense_yaw(trajectory, world, of_yaw, hints);
  if (world.heading) sense_heading(trajectory, world, of_heading, hints);
  std::stable_sort(hints.begin(), hints.end(),
                   [](const MotionHint& a, const MotionHint& b) { return a.time_s < b.time_s; });
  return hints;
}

}  // namespace echoway::sim
