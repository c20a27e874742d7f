#pragma once

#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"
#include "scene/scene.hpp"
#include "tracker/echo_model.hpp"
#include "tracker/history.hpp"
#include "tracker/motion.hpp"

namespace echoway::tracker {

/// What a search knows besides its domain.
struct SearchTools {
  const EchoModel& model;
  scene::Scene& scene;
  const MotionParameters& motion;
  const BeltConfig& belt;
  const History& history;
  const Building& building;
  double log_scale;                    ///< What is known of the sound-speed scale.
  double log_scale_sigma;
  double gyro_bias;
  double pace;                         ///< The wearer's usual one, m/s.
};

}  // namespace echoway::tracker
