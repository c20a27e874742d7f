#pragma once

#include <cstdint>

#include "echoway/building/building.hpp"
#include "echoway/geometry/vec2.hpp"
#include "tracker/elementary.hpp"
#include "tracker/fronts.hpp"
#include "tracker/strangers.hpp"

namespace echoway::tracker {

/// Upper triangle of the covariance of (x, y, speed, log sound-speed scale), row by row.
struct Covariance {
  double xx = 0.0, xy = 0.0, xs = 0.0, xk = 0.0;
  double yy = 0.0, ys = 0.0, yk = 0.0;
  double ss = 0.0, sk = 0.0;
  double kk = 0.0;
};

enum class Gait : std::uint8_t {
  standing,   ///< Perhaps turning on the spot.
  walking,    ///< Along the heading, at a pace that changes slowly.
  away,       ///< On stairs or in an elevator: in no room.
};

/// One hypothesis of a Rao-Blackwellised filter (Doucet et al. 2000): room, gait, heading and what turns it
/// are sampled; given them, every range is almost linear in position, speed and sound-speed scale, which a
/// Kalman filter carries exactly.
struct Particle {
  double weight = 0.0;
  RoomIndex room = kNoRoom;
  Gait gait = Gait::standing;
  Vec2 position{};           ///< Mean, in the room's frame.
  double speed = 0.0;        ///< Mean, along the heading.
  double log_scale = 0.0;    ///< Mean of ln(measured range / true range).
  Covariance cov{};
  double heading = 0.0;      ///< [-pi, pi], in the room's frame.
  Vec2 facing{1.0, 0.0};     ///< cos, sin of heading.
  double gyro_bias = 0.0;    ///< rad/s, what the gyroscope reads when nothing turns.
  double turn_rate = 0.0;    ///< rad/s, when no gyroscope tells.
  double away_s = 0.0;       ///< Seconds since the particle set out on stairs or an elevator,
  std::int32_t link_end = 0; ///< and on which: an end of LevelLinks.
  double foreseen = 1.0;     ///< Factor that takes back, for each firing that a search knew when it drew the particle,
                             ///< what that firing had to do with its choice.
  Fronts fronts{};           ///< What stands before walls, and is in no plan.
  Strangers strangers{};     ///< What answered of late and is in no plan.
};

/// After `heading` was set: the same of `facing`.
inline void face_heading(Particle& p) noexcept {
  const SinCos f = fast_sincos(p.heading);
  p.facing = {f.cos, f.sin};
}

/// Turns a particle where it stands, with all that it knows, by the angle whose cosine and sine `rotation` holds: into
/// the frame of another room, say.
void turn(Particle& p, Vec2 rotation) noexcept;

/// Another speed, m/s, of standard deviation `sigma`, that nothing known so far tells anything about.
inline void forget_speed(Particle& p, double speed, double sigma) noexcept {
  p.speed = speed;
  p.cov.xs = p.cov.ys = p.cov.sk = 0.0;
  p.cov.ss = sigma * sigma;
}

}  // namespace echoway::tracker
